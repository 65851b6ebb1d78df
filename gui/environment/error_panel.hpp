#pragma once

#include <QComboBox>
#include <QLabel>
#include <QSlider>
#include <QWidget>
#include <functional>
#include <vector>

#include "eyebridge/hal/environment.hpp"

namespace eyebridge::gui {

/// How much robots err: for all or for one of them a preset, or what the robot came with, and how
/// much of it. What is chosen holds at once.
class ErrorPanel final : public QWidget {
  Q_OBJECT
 public:
  /// `environment` is lent.
  ErrorPanel(hal::Environment& environment, QWidget* parent);

  /// Offers the robots that `look` shows; robots that have come get what all have.
  void follow(const hal::WorldLook& look);
  /// Told why errors could not be set.
  std::function<void(const QString&)> on_trouble;

 private:
  /// What is chosen for a robot.
  struct Choice {
    int kind = 0;       ///< 0: as it came; else a preset, from 1.
    int percent = 100;  ///< Of these errors.

    friend bool operator==(const Choice&, const Choice&) = default;
  };

  [[nodiscard]] Choice& choice_of_target();
  /// Shows what is chosen for the target.
  void show_choice();
  /// Takes what a person chose, and gives it to the robots that it is for.
  void choose();
  void give(std::size_t robot);

  hal::Environment& environment_;
  std::vector<std::shared_ptr<const robot::RobotModel>>
      models_;  ///< As the robots came; null once removed.
  Choice for_all_;
  std::vector<Choice> choices_;  ///< Of each robot.
  QComboBox* target_;            ///< First all, then each robot.
  QComboBox* kind_;
  QSlider* share_;
  QLabel* percent_;
  bool is_showing_ = false;  ///< Not a person moves the controls, but we.
};

}  // namespace eyebridge::gui
