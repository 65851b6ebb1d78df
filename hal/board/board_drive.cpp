#include "board/board_drive.hpp"

#include "arguments/arguments.hpp"
#include "eyebridge/base/math.hpp"

namespace eyebridge::hal {

Result<void> BoardDrive::set_speed(const Twist& twist) {
  return check_speed(twist).and_then([&] { return controller_.set_speed(twist); });
}

Result<void> BoardDrive::start(const DriveGoal& goal) {
  return check_goal(goal).and_then([&] { return controller_.start(goal); });
}

Result<void> BoardDrive::set_odometry(const Pose& pose) {
  return check_pose(pose).and_then([&] {
    return controller_.set_odometry({pose.x, pose.y, wrap_angle(pose.theta)});
  });
}

}  // namespace eyebridge::hal
