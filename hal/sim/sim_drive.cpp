#include "sim/sim_drive.hpp"

#include "arguments/arguments.hpp"

namespace eyebridge::hal {
namespace {

DriveProgress progress_of(robot::DriveState state) {
  switch (state) {
    case robot::DriveState::Idle:
      return DriveProgress::Done;
    case robot::DriveState::Driving:
      return DriveProgress::Driving;
    case robot::DriveState::Failed:
      return DriveProgress::Failed;
  }
  return DriveProgress::Failed;
}

}  // namespace

Result<void> SimDrive::set_speed(const Twist& twist) {
  return check_speed(twist).map(
      [&] { world_.locked([&](auto& sim) { sim.set_speed(robot_, twist); }); });
}

Result<void> SimDrive::start(const DriveGoal& goal) {
  return check_goal(goal).map([&] { world_.locked([&](auto& sim) { sim.drive(robot_, goal); }); });
}

Result<DriveStatus> SimDrive::status() {
  return world_.sensed([&](auto& sim) {
    const unsigned stalled = sim.stalled(robot_);
    return DriveStatus{progress_of(sim.drive_state(robot_)), sim.remaining(robot_),
                       (stalled & robot::kStallLeft) != 0, (stalled & robot::kStallRight) != 0};
  });
}

Result<Twist> SimDrive::measured_twist() {
  return world_.sensed([&](auto& sim) { return sim.measured_twist(robot_); });
}

Result<Pose> SimDrive::odometry() {
  return world_.sensed([&](auto& sim) { return sim.odometry(robot_); });
}

Result<void> SimDrive::set_odometry(const Pose& pose) {
  return check_pose(pose).map(
      [&] { world_.locked([&](auto& sim) { sim.set_odometry(robot_, pose); }); });
}

}  // namespace eyebridge::hal
