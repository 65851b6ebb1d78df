#include "environment/keyboard_driver.hpp"

#include <Qt>

namespace eyebridge::gui {
namespace {

// Of what the robot can: a person wants to hit doors.
constexpr double kShareOfSpeed = 0.5;
constexpr double kShareOfTurn = 1.0 / 3.0;

}  // namespace

bool KeyboardDriver::knows(int key) {
  return key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_Left || key == Qt::Key_Right;
}

double KeyboardDriver::axis(int positive, int negative) const {
  return static_cast<double>(down_.count(positive)) - static_cast<double>(down_.count(negative));
}

Twist KeyboardDriver::twist(const robot::RobotModel& model) const {
  return {kShareOfSpeed * model.drive.max_linear * axis(Qt::Key_Up, Qt::Key_Down),
          kShareOfTurn * model.drive.max_angular * axis(Qt::Key_Left, Qt::Key_Right)};
}

}  // namespace eyebridge::gui
