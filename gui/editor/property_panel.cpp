#include "editor/property_panel.hpp"

#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPixmap>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

namespace eyebridge::gui {
namespace {

constexpr int kNarrowest = 90;  // pixels, of a field

}  // namespace

PropertyPanel::PropertyPanel(Document& document, QWidget* parent)
    : QWidget(parent), document_(document), title_(new QLabel(this)), form_(new QFormLayout) {
  auto* column = new QVBoxLayout(this);
  column->addWidget(title_);
  column->addLayout(form_);
  column->addStretch();
  refresh();
}

void PropertyPanel::set_catalogue(const Catalogue& catalogue) {
  catalogue_ = catalogue;
  is_built_ = false;
  refresh();
}

std::vector<Item> PropertyPanel::shown() const {
  const Selection& selection = document_.selection();
  std::vector<Item> items;
  for (const Item& item : selection) {
    if (has(document_.plan(), item)) items.push_back(item);
  }
  return items;
}

void PropertyPanel::rebuild(std::optional<Kind> kind) {
  is_built_ = true;
  kind_ = kind;
  fields_.clear();
  while (form_->rowCount() > 0) {
    const QFormLayout::TakeRowResult row = form_->takeRow(0);
    for (QLayoutItem* const item : {row.labelItem, row.fieldItem}) {
      if (item == nullptr) continue;
      // One of them may be what has just told of a change: it goes when that is over.
      QWidget* const widget = item->widget();
      delete item;
      widget->disconnect(this);  // what losing the keyboard makes it tell is not meant any more
      widget->hide();
      widget->deleteLater();
    }
  }
  rows_ = kind ? properties_of(*kind, catalogue_) : floor_properties();
  for (const Property& property : rows_) {
    QWidget* const field = make_field(property);
    field->setAccessibleName(property.name);
    // As wide as the panel: their own idea is that of the longest number.
    field->setMinimumWidth(kNarrowest);
    field->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    fields_[property.name] = field;
    form_->addRow(property.name, field);
  }
}

void PropertyPanel::refresh() {
  const std::vector<Item> items = shown();
  const bool mixed =
      std::ranges::any_of(items, [&](const Item& item) { return item.kind != items.front().kind; });
  std::optional<Kind> kind;
  if (!items.empty()) kind = items.front().kind;
  if (!is_built_ || kind != kind_) rebuild(kind);
  title_->setText(items.empty()       ? tr("Floor")
                  : mixed             ? tr("%1 different things").arg(items.size())
                  : items.size() == 1 ? name_of(*kind)
                                      : tr("%1: %2 of them").arg(name_of(*kind)).arg(items.size()));
  for (const Property& property : rows_) {
    QWidget& field = *fields_.at(property.name);
    const Item item = items.empty() ? Item{} : items.front();
    const QVariant value = mixed ? QVariant() : property.get(document_.plan(), item);
    form_->setRowVisible(&field, value.isValid());
    if (value.isValid()) show_value(property, field, value);
  }
}

QWidget* PropertyPanel::make_field(const Property& property) {
  const QString name = property.name;
  switch (property.type) {
    case Property::Type::Number: {
      auto* box = new QDoubleSpinBox(this);
      box->setDecimals(property.decimals);
      box->setRange(property.low, property.high);
      if (!property.unit.isEmpty()) box->setSuffix(' ' + property.unit);
      box->setSpecialValueText(property.none);
      box->setKeyboardTracking(false);  // one step a number, not one a digit
      box->setSingleStep(property.unit == "mm" ? 10 : property.unit == "°" ? 15 : 0.1);
      connect(box, &QDoubleSpinBox::valueChanged, this,
              [this, name](double value) { set_value(name, value); });
      return box;
    }
    case Property::Type::Flag: {
      auto* box = new QCheckBox(this);
      connect(box, &QCheckBox::clicked, this, [this, name](bool on) { set_value(name, on); });
      return box;
    }
    case Property::Type::Text: {
      auto* line = new QLineEdit(this);
      connect(line, &QLineEdit::editingFinished, this,
              [this, name, line] { set_value(name, line->text()); });
      return line;
    }
    case Property::Type::Choice: {
      auto* box = new QComboBox(this);
      box->addItems(property.choices);
      connect(box, &QComboBox::textActivated, this,
              [this, name](const QString& text) { set_value(name, text); });
      return box;
    }
    case Property::Type::Colour: {
      auto* button = new QPushButton(this);
      connect(button, &QPushButton::clicked, this, [this, name] { ask_for_colour(name); });
      return button;
    }
  }
  return new QWidget(this);
}

void PropertyPanel::show_value(const Property& property, QWidget& field, const QVariant& value) {
  const QSignalBlocker quiet(field);
  switch (property.type) {
    case Property::Type::Number:
      return static_cast<QDoubleSpinBox&>(field).setValue(value.toDouble());
    case Property::Type::Flag:
      return static_cast<QCheckBox&>(field).setChecked(value.toBool());
    case Property::Type::Text: {
      auto& line = static_cast<QLineEdit&>(field);
      if (line.text() != value.toString()) line.setText(value.toString());
      return;
    }
    case Property::Type::Choice: {
      auto& box = static_cast<QComboBox&>(field);
      if (box.findText(value.toString()) < 0) box.addItem(value.toString());
      return box.setCurrentText(value.toString());
    }
    case Property::Type::Colour: {
      auto& button = static_cast<QPushButton&>(field);
      QPixmap swatch(32, 16);
      swatch.fill(value.value<QColor>());
      button.setIcon(swatch);
      button.setText(value.value<QColor>().name());
      return;
    }
  }
}

void PropertyPanel::set_value(const QString& name, const QVariant& value) {
  const auto row = std::ranges::find(rows_, name, &Property::name);
  if (row == rows_.end()) return;
  const Property property = *row;  // the edit may build the rows anew
  std::vector<Item> items = shown();
  if (items.empty()) items.emplace_back();
  // What is as shown is not meant: a number is shown rounded.
  const QVariant before = property.get(document_.plan(), items.front());
  if (items.size() == 1 && before == value) return;
  document_.edit(tr("Change %1").arg(name), [&](Plan& plan) {
    for (const Item& item : items) property.set(plan, item, value);
  });
  refresh();
}

void PropertyPanel::ask_for_colour(const QString& name) {
  const auto row = std::ranges::find(rows_, name, &Property::name);
  const std::vector<Item> items = shown();
  if (row == rows_.end() || items.empty()) return;
  auto* dialog = new QColorDialog(row->get(document_.plan(), items.front()).value<QColor>(), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QColorDialog::colorSelected, this,
          [this, name](const QColor& chosen) { set_value(name, chosen); });
  dialog->open();
}

QWidget* PropertyPanel::field(const QString& name) const {
  const auto found = fields_.find(name);
  return found == fields_.end() ? nullptr : found->second;
}

}  // namespace eyebridge::gui
