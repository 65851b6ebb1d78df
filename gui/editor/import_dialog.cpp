#include "editor/import_dialog.hpp"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>

#include "eyebridge/base/units.hpp"
#include "widgets/ask_for_file.hpp"

namespace eyebridge::gui {

ImportDialog::ImportDialog(QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Import floor plan"));
  auto* const form = new QFormLayout(this);
  auto* const file = new QLineEdit(this);
  auto* const browse = new QPushButton(tr("Browse..."), this);
  auto* const row = new QHBoxLayout;
  row->addWidget(file, 1);
  row->addWidget(browse);
  auto* const label = new QLabel(tr("&Picture"), this);
  label->setBuddy(file);
  form->addRow(label, row);
  auto* const scale = new QDoubleSpinBox(this);
  scale->setRange(0.01, 100000);
  scale->setDecimals(2);
  scale->setValue(10);
  scale->setSuffix(tr(" mm"));
  form->addRow(tr("One pixel &is"), scale);
  auto* const threshold = new QSpinBox(this);
  threshold->setRange(0, 255);
  threshold->setSpecialValueText(tr("by itself"));
  form->addRow(tr("Walls are &darker than"), threshold);
  auto* const tolerance = new QDoubleSpinBox(this);
  tolerance->setRange(0, 100);
  tolerance->setValue(1);
  tolerance->setSuffix(tr(" pixels"));
  form->addRow(tr("&Straighten by up to"), tolerance);
  auto* const replaces = new QCheckBox(tr("&Replace the walls there are"), this);
  replaces->setChecked(true);
  form->addRow(replaces);
  auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  form->addRow(buttons);
  auto* const ok = buttons->button(QDialogButtonBox::Ok);
  ok->setEnabled(false);
  connect(file, &QLineEdit::textChanged, ok,
          [ok](const QString& text) { ok->setEnabled(!text.isEmpty()); });
  connect(browse, &QPushButton::clicked, this, [this, file] {
    ask_for_file(*this, tr("Floor plan"), {}, tr("Pictures (*.png *.jpg *.jpeg *.bmp *.pgm *.gif)"),
                 [file](const QString& path) { file->setText(path); });
  });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons, &QDialogButtonBox::accepted, this, [=, this] {
    files::FloorPlanOptions options;
    options.metres_per_pixel = mm_to_m(scale->value());
    if (threshold->value() > 0) options.threshold = threshold->value();
    options.tolerance = tolerance->value();
    if (on_choice) on_choice(file->text(), options, replaces->isChecked());
    accept();
  });
}

}  // namespace eyebridge::gui
