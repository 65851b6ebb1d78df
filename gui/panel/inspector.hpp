#pragma once

#include <QTreeWidget>
#include <vector>

#include "eyebridge/hal/device_notes.hpp"
#include "keys.hpp"

namespace eyebridge::gui {

/// What the program last read from its robot's sensors and wrote to its actuators: name, value,
/// unit, when. Asks no device itself: what the program never used is shown as such.
class Inspector final : public QTreeWidget {
  Q_OBJECT

 public:
  enum Column { kName, kValue, kUnit, kTime };

  /// Both are lent.
  Inspector(const hal::DeviceNotes& notes, const robios::Keys& keys, QWidget* parent);

  /// Shows what is new.
  void refresh();
  /// The item whose names, from the group on, are these, as "Drive/x"; null where there is none.
  [[nodiscard]] const QTreeWidgetItem* find(const QString& path) const;

  [[nodiscard]] QSize sizeHint() const override { return {360, 200}; }

 private:
  /// An item for each part of a quantity.
  struct Row {
    const hal::NotedValue* value;
    std::vector<QTreeWidgetItem*> parts;
    std::uint64_t shown = 0;  ///< The note's count.
  };

  QTreeWidgetItem* group(const QString& title);
  void add_row(const hal::NotedValue& value);
  void show_note(Row& row, const hal::Note& note);
  void refresh_keys();
  void put(QTreeWidgetItem* item, const QString& text, Time time);

  const hal::DeviceNotes& notes_;
  const robios::Keys& keys_;
  std::vector<Row> rows_;
  QTreeWidgetItem* key_;
  QTreeWidgetItem* touch_;
  QTreeWidgetItem* code_;
};

}  // namespace eyebridge::gui
