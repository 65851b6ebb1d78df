#pragma once

#include "eyebridge/base/clock.hpp"
#include "hand/carried_robot.hpp"

namespace eyebridge::hal {

/// How long a call waits, on the robot's clock, for a robot that has gone out of sight, from the
/// moment on at which it was seen last (at first, from the start): the person needs to find a
/// marker. Then calls fail at once until it is seen again.
inline constexpr Time kHandPatience = std::chrono::seconds(10);

/// The robot's pose in the world; waits on `clock` for a robot that is lost, within kHandPatience.
Result<Pose> wait_for_pose(const CarriedRobot& robot, Clock& clock);

/// The drive of a robot that a person carries: commands become instructions, readings come from
/// what the camera sees. All but set_speed() wait for a robot that is lost as wait_for_pose().
class HandDrive final : public Drive {
 public:
  /// Both are lent.
  HandDrive(CarriedRobot& robot, Clock& clock) : robot_(robot), clock_(clock) {}

  Result<void> set_speed(const Twist& twist) override;
  Result<void> start(const DriveGoal& goal) override;
  Result<DriveStatus> status() override;
  Result<Twist> measured_twist() override;
  Result<Pose> odometry() override;
  Result<void> set_odometry(const Pose& pose) override;

 private:
  template <class Ask>
  auto when_seen(Ask&& ask) -> decltype(ask()) {
    const Result<Pose> seen = wait_for_pose(robot_, clock_);
    if (!seen) return tl::unexpected(seen.error());
    return ask();
  }

  CarriedRobot& robot_;
  Clock& clock_;
};

}  // namespace eyebridge::hal
