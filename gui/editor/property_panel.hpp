#pragma once

#include <QCoreApplication>
#include <QFormLayout>
#include <QLabel>
#include <QWidget>
#include <map>
#include <optional>
#include <vector>

#include "editor/document.hpp"
#include "editor/properties.hpp"

namespace eyebridge::gui {

/// What can be typed of what is selected, or of the floor when nothing is: each value a step that
/// can be undone. Of several things of one kind a value is given to all.
class PropertyPanel final : public QWidget {
  Q_DECLARE_TR_FUNCTIONS(PropertyPanel)

 public:
  /// `document` is lent.
  PropertyPanel(Document& document, QWidget* parent);

  void set_catalogue(const Catalogue& catalogue);
  /// The document has changed.
  void refresh();
  /// As if a person had typed it; nothing when there is no such row.
  void set_value(const QString& name, const QVariant& value);
  /// The field of that name; null when there is none.
  [[nodiscard]] QWidget* field(const QString& name) const;

 private:
  [[nodiscard]] std::vector<Item> shown() const;
  void rebuild(std::optional<Kind> kind);
  QWidget* make_field(const Property& property);
  void show_value(const Property& property, QWidget& field, const QVariant& value);
  void ask_for_colour(const QString& name);

  Document& document_;
  Catalogue catalogue_;
  bool is_built_ = false;
  std::optional<Kind> kind_;  ///< Whose rows there are; none: the floor's.
  std::vector<Property> rows_;
  std::map<QString, QWidget*> fields_;
  QLabel* title_;
  QFormLayout* form_;
};

}  // namespace eyebridge::gui
