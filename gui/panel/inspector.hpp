#pragma once

#include <QTreeWidget>
#include <vector>

#include "eyebridge/hal/device_notes.hpp"
#include "keys.hpp"
#include "panel/stamp_times.hpp"

namespace eyebridge::gui {

/// What the program last read from its robot's sensors and wrote to its actuators: name, value,
/// unit, when. Asks no device itself: what the program never used is shown as such.
class Inspector final : public QTreeWidget {
  Q_OBJECT

 public:
  enum Column { kName, kValue, kUnit, kTime };

  /// Both are lent.
  Inspector(const hal::DeviceNotes& notes, const robios::Keys& keys, QWidget* parent);

  /// Finds out when what is new was read or written: often, also while nobody can see it.
  void look();
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
    hal::Note note{};         ///< The last one that was looked at …
    Time time{0};             ///< … and when it was made.
    std::uint64_t shown = 0;  ///< Its count, when it was shown.
  };

  QTreeWidgetItem* group(const QString& title);
  void add_row(const hal::NotedValue& value);
  void show_note(Row& row);
  void refresh_keys();
  void put(QTreeWidgetItem* item, const QString& text, Time time);

  const robios::Keys& keys_;
  StampTimes times_;
  std::vector<Row> rows_;
  QTreeWidgetItem* key_;
  QTreeWidgetItem* touch_;
  QTreeWidgetItem* code_;
};

}  // namespace eyebridge::gui
