#include "environment/add_robot_panel.hpp"

#include <QApplication>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QPointer>
#include <QProcess>
#include <QThreadPool>
#include <array>
#include <string>
#include <vector>

#include "editor/catalogue.hpp"
#include "eyebridge/base/units.hpp"
#include "widgets/ask_for_file.hpp"

namespace eyebridge::gui {

AddRobotPanel::AddRobotPanel(robios::Crew* crew, QWidget* parent)
    : QWidget(parent),
      crew_(crew),
      model_(new QComboBox(this)),
      program_(new QLineEdit(this)),
      place_(new PlaceButton("add_place", this)) {
  model_->setEditable(true);
  model_->setObjectName("add_model");
  model_->setAccessibleName(tr("Model, or .robi file"));
  const Catalogue catalogue;
  for (const std::string& name : catalogue.names()) model_->addItem(QString::fromStdString(name));
  program_->setObjectName("add_program");
  program_->setPlaceholderText(tr("none: it stands there"));
  program_->setAccessibleName(tr("Program and its arguments"));
  auto* const choose = new QPushButton(tr("..."), this);
  choose->setAccessibleName(tr("Choose a program"));
  connect(choose, &QPushButton::clicked, this, &AddRobotPanel::choose_program);
  auto* const row = new QHBoxLayout;
  row->addWidget(program_, 1);
  row->addWidget(choose);
  auto* const form = new QFormLayout(this);
  form->addRow(tr("Model"), model_);
  form->addRow(tr("Program"), row);
  form->addRow(place_);
  if (crew_ != nullptr) return;
  auto* const why = new QLabel(tr("Robots cannot be added to a run of this kind."), this);
  why->setWordWrap(true);
  form->addRow(why);
  const std::array<QWidget*, 4> controls = {model_, program_, choose, place_};
  for (QWidget* const control : controls) control->setEnabled(false);
}

void AddRobotPanel::follow(const hal::WorldLook& look) {
  for (; known_ < look.robots.size(); ++known_) {
    const QString name = QString::fromStdString(look.robots[known_].model->name);
    if (model_->findText(name) < 0) model_->insertItem(0, name);
    if (known_ == 0) model_->setCurrentIndex(model_->findText(name));
  }
}

void AddRobotPanel::choose_program() {
  ask_for_file(*this, tr("Program"), {}, {},
               [this](const QString& path) { program_->setText('"' + path + '"'); });
}

void AddRobotPanel::add(const Pose& pose) {
  if (crew_ == nullptr) return;
  std::vector<std::string> words{model_->currentText().trimmed().toStdString(),
                                 QString::number(m_to_mm(pose.x), 'f', 1).toStdString(),
                                 QString::number(m_to_mm(pose.y), 'f', 1).toStdString(),
                                 QString::number(rad_to_deg(pose.theta), 'f', 1).toStdString()};
  for (const QString& word : QProcess::splitCommand(program_->text())) {
    words.push_back(word.toStdString());
  }
  // Not here: a run that is paused answers when it goes on.
  QThreadPool::globalInstance()->start([crew = crew_, words, panel = QPointer(this)] {
    const Result<std::size_t> index = crew->add(words);
    const QString answer = index ? tr("Robot %1 has entered").arg(*index + 1)
                                 : QString::fromStdString(index.error().what);
    QMetaObject::invokeMethod(
        qApp,
        [panel, answer] {
          if (panel && panel->on_answer) panel->on_answer(answer);
        },
        Qt::QueuedConnection);
  });
}

}  // namespace eyebridge::gui
