#pragma once

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QWidget>
#include <functional>

#include "environment/place_button.hpp"
#include "eyebridge/hal/environment.hpp"
#include "windows/windows.hpp"

namespace eyebridge::gui {

/// Asks for one more robot: what it is, what it runs, and then where, which a person shows by
/// mouse.
class AddRobotPanel final : public QWidget {
  Q_OBJECT
 public:
  /// `crew`, lent, lets robots in; null where a run has one robot only, which is said then.
  AddRobotPanel(robios::Crew* crew, QWidget* parent);

  /// Offers the models that `look` shows, too.
  void follow(const hal::WorldLook& look);
  /// Lets the robot in at `pose`; the answer comes later, as the run may be paused.
  void add(const Pose& pose);
  /// Down while a place is to be shown.
  [[nodiscard]] PlaceButton& place_button() { return *place_; }

  /// Told what became of a robot.
  std::function<void(const QString&)> on_answer;

 private:
  void choose_program();

  robios::Crew* const crew_;
  QComboBox* model_;
  QLineEdit* program_;
  PlaceButton* place_;
  std::size_t known_ = 0;  ///< Robots whose models are offered.
};

}  // namespace eyebridge::gui
