#include "sim/sim_drive.hpp"

namespace eyebridge::hal {
namespace {

constexpr const char* kName = "drive";

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
  // A sum is finite only if its parts are: one check for both.
  return require(std::isfinite(twist.linear + twist.angular), kName, twist.linear + twist.angular,
                 "a finite speed")
      .map([&] { world_.locked([&](auto& sim) { sim.set_speed(robot_, twist); }); });
}

Result<void> SimDrive::start(const DriveGoal& goal) {
  return require(std::isfinite(goal.distance), kName, goal.distance, "a finite distance")
      .and_then(
          [&] { return require(std::isfinite(goal.angle), kName, goal.angle, "a finite angle"); })
      .and_then([&] {
        return require(std::isfinite(goal.speed) && goal.speed >= 0.0, kName, goal.speed,
                       "a speed of at least 0");
      })
      .map([&] { world_.locked([&](auto& sim) { sim.drive(robot_, goal); }); });
}

Result<DriveStatus> SimDrive::status() {
  return world_.locked([&](auto& sim) {
    const unsigned stalled = sim.stalled(robot_);
    return DriveStatus{progress_of(sim.drive_state(robot_)), sim.remaining(robot_),
                       (stalled & robot::kStallLeft) != 0, (stalled & robot::kStallRight) != 0};
  });
}

Result<Twist> SimDrive::measured_twist() {
  return world_.locked([&](auto& sim) { return sim.measured_twist(robot_); });
}

Result<Pose> SimDrive::odometry() {
  return world_.locked([&](auto& sim) { return sim.odometry(robot_); });
}

Result<void> SimDrive::set_odometry(const Pose& pose) {
  return require(std::isfinite(pose.x + pose.y + pose.theta), kName, pose.x + pose.y + pose.theta,
                 "a finite pose")
      .map([&] { world_.locked([&](auto& sim) { sim.set_odometry(robot_, pose); }); });
}

}  // namespace eyebridge::hal
