#pragma once

#include "eyebridge/base/drive_goal.hpp"
#include "eyebridge/robot/arc.hpp"
#include "eyebridge/robot/ramp.hpp"
#include "eyebridge/robot/simulation.hpp"

namespace eyebridge::robot {

/// The v-omega controller: turns commands into one twist a step, ramped, and knows when a goal is
/// reached.
///
/// Progress is what the wheels report, so errors of the drive make it miss, as on a real robot.
/// A part of a goal that is zero (the turn of a straight, the way of a turn) is only slowed down
/// from what the robot had, not corrected. But what the heading lacks when a goal is reached (a
/// tick's worth, or what a straight was off) is added to the next turn, so that it does not add up
/// over many. Each step: next(), then advance() or hold().
class DriveController {
 public:
  explicit DriveController(const DriveLimits& limits) : limits_(limits) {}

  /// Ramps from `present` to `target` and stays there.
  void set_speed(const Twist& target, const Twist& present);
  /// Drives to `goal`, starting from the speed `present`.
  void start(const DriveGoal& goal, const Twist& present);
  /// Speed zero at once; a goal is dropped.
  void stop();
  /// Like stop(), and the goal counts as failed.
  void fail();

  /// The twist for the step to come. `rolling` is how far the robot would still go if the motors
  /// were told to stand still now (their lag); zero for motors without lag.
  Twist next(const PathStep& rolling);
  /// Tells what the wheels measured in this step.
  void advance(const PathStep& measured);
  /// Tells that an obstacle held the robot after `measured`: the ramp starts again from zero, that
  /// of the turn unless it `turns` on.
  void hold(const PathStep& measured, bool turns);

  [[nodiscard]] const Twist& twist() const { return twist_; }
  [[nodiscard]] DriveState state() const { return state_; }
  /// Metres to go, >= 0; 0 without a goal and for turns.
  [[nodiscard]] double remaining() const;
  /// True when next() would give zero for ever.
  [[nodiscard]] bool at_rest() const {
    return state_ != DriveState::Driving && twist_ == Twist{} && target_ == Twist{};
  }
  /// Radians that the goals so far wanted and the wheels lack; advance() takes a step's angle off.
  [[nodiscard]] double heading_owed() const { return heading_owed_; }
  /// After steps of which somebody else kept account.
  void set_heading_owed(double owed) { heading_owed_ = owed; }
  /// True when next() gives the same twist for ever.
  [[nodiscard]] bool settled() const { return state_ != DriveState::Driving && twist_ == target_; }
  /// Where the ramp of speed mode ends.
  [[nodiscard]] const Twist& target() const { return target_; }
  [[nodiscard]] const DriveLimits& limits() const { return limits_; }
  /// Holds from the next step on; what is under way goes on.
  void set_limits(const DriveLimits& limits) { limits_ = limits; }

 private:
  /// Distance or angle of a goal.
  struct Part {
    bool open = false;  ///< Not there yet.
    double left = 0.0;  ///< What remains, signed.
    double side = 0.0;  ///< Sign of `left` in the step before.

    void set(double amount);
    /// `step` is one of its speed's ramp.
    void advance(double travelled, double speed, double step, double end,
                 const DriveLimits& limits);
  };

  /// The angle of a goal of `angle` with what those before it owe.
  double settle_heading(double angle);
  [[nodiscard]] Twist towards_goal(double distance, double angle) const;

  DriveLimits limits_;
  Twist twist_;   ///< Commanded in the last step.
  Twist target_;  ///< Of speed mode.
  Part distance_;
  Part angle_;
  bool keeps_heading_ = false;  ///< Goals follow each other, nothing else drove in between.
  double heading_owed_ = 0.0;   ///< See heading_owed().
  double linear_top_ = 0.0;     ///< Of the running goal.
  double angular_top_ = 0.0;    ///< Of the running goal.
  DriveState state_ = DriveState::Idle;
};

}  // namespace eyebridge::robot
