#include "environment/add_thing_panel.hpp"

#include <QFormLayout>

#include "editor/catalogue.hpp"
#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/files/readers.hpp"

namespace eyebridge::gui {
namespace {

/// How a `.sim` file calls `name` and what it says after the place: sizes, which one may edit.
QString words_of(const std::string& name) {
  const std::string line = files::write_object_text(builtin_thing(name));
  // "NAME x y phi MORE": the place is shown by mouse.
  QStringList words = QString::fromStdString(line).trimmed().split(' ');
  words.remove(1, 3);
  return words.join(' ');
}

}  // namespace

AddThingPanel::AddThingPanel(hal::Environment& environment, QWidget* parent)
    : QWidget(parent),
      environment_(environment),
      thing_(new QComboBox(this)),
      more_(new QLineEdit(this)),
      place_(new PlaceButton("thing_place", this)) {
  thing_->setEditable(true);
  thing_->setInsertPolicy(QComboBox::NoInsert);
  thing_->setObjectName("thing_kind");
  thing_->setAccessibleName(tr("Thing, and what its line says of its size"));
  thing_->setToolTip(tr("A box has length and width, a polygon x and y of its corners, all in mm"));
  for (const std::string& name : builtin_things()) thing_->addItem(words_of(name));
  more_->setObjectName("thing_more");
  more_->setPlaceholderText(tr("as usual; or: mass 2; wander 100"));
  more_->setAccessibleName(tr("How it behaves"));
  more_->setToolTip(
      tr("Lines of a .sim file with ; between them: mass, friction, restitution, fixed, "
         "path, follow, flee, wander, yields"));
  auto* const form = new QFormLayout(this);
  form->addRow(tr("Thing"), thing_);
  form->addRow(tr("Behaves"), more_);
  form->addRow(place_);
}

void AddThingPanel::add(const Pose& pose) {
  QStringList words = thing_->currentText().simplified().split(' ');
  const QString place = QString("%1 %2 %3")
                            .arg(m_to_mm(pose.x), 0, 'f', 1)
                            .arg(m_to_mm(pose.y), 0, 'f', 1)
                            .arg(rad_to_deg(pose.theta), 0, 'f', 1);
  words.insert(1, place);
  const QString text = words.join(' ') + '\n' + more_->text().replace(';', '\n');
  QString answer;
  try {
    const auto object = files::read_object_text(text.toStdString(), tr("thing").toStdString());
    const Result<int> number = environment_.control().add_object(object);
    answer = number ? tr("Object %1 is there").arg(*number)
                    : QString::fromStdString(number.error().what);
  } catch (const ConfigError& error) {
    answer = QString::fromUtf8(error.what());
  }
  if (on_answer) on_answer(answer);
}

}  // namespace eyebridge::gui
