#include "board/board_drive.hpp"

#include "eyebridge/base/math.hpp"

namespace eyebridge::hal {
namespace {

constexpr const char* kName = "drive";

}  // namespace

Result<void> BoardDrive::set_speed(const Twist& twist) {
  // A sum is finite only if its parts are: one check for both.
  const double sum = twist.linear + twist.angular;
  return require(std::isfinite(sum), kName, sum, "a finite speed").and_then([&] {
    return controller_.set_speed(twist);
  });
}

Result<void> BoardDrive::start(const DriveGoal& goal) {
  return require(std::isfinite(goal.distance), kName, goal.distance, "a finite distance")
      .and_then(
          [&] { return require(std::isfinite(goal.angle), kName, goal.angle, "a finite angle"); })
      .and_then([&] {
        return require(std::isfinite(goal.speed) && goal.speed >= 0.0, kName, goal.speed,
                       "a speed of at least 0");
      })
      .and_then([&] { return controller_.start(goal); });
}

Result<void> BoardDrive::set_odometry(const Pose& pose) {
  const double sum = pose.x + pose.y + pose.theta;
  return require(std::isfinite(sum), kName, sum, "a finite pose").and_then([&] {
    return controller_.set_odometry({pose.x, pose.y, wrap_angle(pose.theta)});
  });
}

}  // namespace eyebridge::hal
