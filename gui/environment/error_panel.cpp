#include "environment/error_panel.hpp"

#include <QFormLayout>
#include <QHBoxLayout>

#include "eyebridge/robot/error_presets.hpp"

namespace eyebridge::gui {

ErrorPanel::ErrorPanel(hal::Environment& environment, QWidget* parent)
    : QWidget(parent),
      environment_(environment),
      target_(new QComboBox(this)),
      kind_(new QComboBox(this)),
      share_(new QSlider(Qt::Horizontal, this)),
      percent_(new QLabel(this)) {
  target_->addItem(tr("All robots"));
  target_->setAccessibleName(tr("Robots whose errors are set"));
  target_->setObjectName("error_target");
  kind_->addItem(tr("as at the start"));
  for (const std::string_view name : robot::kErrorPresets) {
    kind_->addItem(QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size())));
  }
  kind_->setAccessibleName(tr("Errors"));
  kind_->setObjectName("error_kind");
  share_->setRange(0, 100);
  share_->setPageStep(10);
  share_->setAccessibleName(tr("Share of the errors, percent"));
  share_->setObjectName("error_share");
  auto* const row = new QHBoxLayout;
  row->addWidget(share_, 1);
  row->addWidget(percent_);
  percent_->setMinimumWidth(fontMetrics().horizontalAdvance("100 %"));
  auto* const form = new QFormLayout(this);
  form->addRow(tr("For"), target_);
  form->addRow(tr("Errors"), kind_);
  form->addRow(tr("Share"), row);
  connect(target_, &QComboBox::currentIndexChanged, this, &ErrorPanel::show_choice);
  connect(kind_, &QComboBox::currentIndexChanged, this, &ErrorPanel::choose);
  connect(share_, &QSlider::valueChanged, this, &ErrorPanel::choose);
  show_choice();
}

void ErrorPanel::follow(const hal::WorldLook& look) {
  while (models_.size() < look.robots.size()) {
    models_.push_back(look.robots[models_.size()].model);
    choices_.push_back(for_all_);
    target_->addItem(tr("Robot %1").arg(models_.size()), static_cast<uint>(models_.size() - 1));
    if (!(for_all_ == Choice{})) give(models_.size() - 1);
  }
  for (std::size_t i = 0; i < look.robots.size(); ++i) {
    if (look.robots[i].is_there || !models_[i]) continue;
    models_[i].reset();
    const int row = target_->findData(static_cast<uint>(i));
    if (row >= 0) target_->removeItem(row);
  }
}

ErrorPanel::Choice& ErrorPanel::choice_of_target() {
  const QVariant robot = target_->currentData();
  return robot.isValid() ? choices_.at(robot.toUInt()) : for_all_;
}

void ErrorPanel::show_choice() {
  is_showing_ = true;
  const Choice& choice = choice_of_target();
  kind_->setCurrentIndex(choice.kind);
  share_->setValue(choice.percent);
  percent_->setText(tr("%1 %").arg(choice.percent));
  is_showing_ = false;
}

void ErrorPanel::choose() {
  if (is_showing_) return;
  const Choice choice{kind_->currentIndex(), share_->value()};
  choice_of_target() = choice;
  percent_->setText(tr("%1 %").arg(choice.percent));
  if (on_trouble) on_trouble({});
  if (const QVariant robot = target_->currentData(); robot.isValid()) {
    give(robot.toUInt());
    return;
  }
  for (std::size_t robot = 0; robot < choices_.size(); ++robot) {
    choices_[robot] = choice;
    give(robot);
  }
}

void ErrorPanel::give(std::size_t robot) {
  if (!models_[robot]) return;
  const Choice& choice = choices_[robot];
  robot::RobotModel model = *models_[robot];
  if (choice.kind > 0) {
    const auto preset = static_cast<std::size_t>(choice.kind - 1);
    robot::set_errors(model, *robot::error_preset(robot::kErrorPresets.at(preset)));
  }
  robot::scale_errors(model, choice.percent / 100.0);
  const Result<void> done = environment_.set_errors(robot, model);
  if (!done && on_trouble) on_trouble(QString::fromStdString(done.error().what));
}

}  // namespace eyebridge::gui
