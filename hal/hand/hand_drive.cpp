#include "hand/hand_drive.hpp"

#include <algorithm>

#include "arguments/arguments.hpp"

namespace eyebridge::hal {
namespace {

constexpr Time kLook = std::chrono::milliseconds(20);

}  // namespace

Result<Pose> wait_for_pose(const CarriedRobot& robot, Clock& clock) {
  for (;;) {
    Result<Pose> pose = robot.pose();
    const Time now = clock.now();
    const Time deadline = robot.last_seen() + kHandPatience;
    if (pose || now >= deadline) return pose;
    clock.wait_until(std::min(deadline, now + kLook));
  }
}

Result<void> HandDrive::set_speed(const Twist& twist) {
  return check_speed(twist).map([&] { robot_.set_speed(twist); });
}

Result<void> HandDrive::start(const DriveGoal& goal) {
  return check_goal(goal).and_then([&] { return when_seen([&] { return robot_.start(goal); }); });
}

Result<DriveStatus> HandDrive::status() {
  return when_seen([&] { return robot_.status(); });
}

Result<Twist> HandDrive::measured_twist() {
  return when_seen([&] { return robot_.twist(); });
}

Result<Pose> HandDrive::odometry() {
  return when_seen([&] { return robot_.odometry(); });
}

Result<void> HandDrive::set_odometry(const Pose& pose) {
  return check_pose(pose).and_then(
      [&] { return when_seen([&] { return robot_.set_odometry(pose); }); });
}

}  // namespace eyebridge::hal
