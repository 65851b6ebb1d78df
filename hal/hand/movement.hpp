#pragma once

#include "eyebridge/base/drive_goal.hpp"
#include "eyebridge/base/pose.hpp"
#include "eyebridge/base/units.hpp"
#include "hand/instruction.hpp"

namespace eyebridge::hal {

// When a movement made by hand counts as made. Passing the goal does, too: a person who overshoots
// is not called back.
inline constexpr double kHandDistance = 0.02;   ///< Metres before the goal.
inline constexpr double kHandAngle = kPi / 60;  ///< Radians before it: 3 deg.

/// How far a person is with the movement that a program asked for. Metres, radians, seconds; not
/// thread-safe.
///
/// Way is counted along the robot's heading, and turn as the change of heading, as wheels would
/// measure them: a step to the side is neither. What a movement is short of its goal, or beyond it,
/// is made up for by those that follow, so that the tolerances do not add up over many: a goal
/// begins where the one before was to end. It begins where the robot is when there was none before,
/// when that one was broken off, after set_speed(), and when the robot is farther than kFarAway, or
/// turned more than kFarTurned, from there.
class Movement {
 public:
  static constexpr double kFarAway = 0.15;    ///< Metres.
  static constexpr double kFarTurned = 0.35;  ///< Radians: 20 deg.

  /// Drive at `twist` until the next command.
  void set_speed(const Twist& twist);
  /// Drive to `goal`; the robot is at `here`. A goal without length or speed stops.
  void start(const DriveGoal& goal, const Pose& here);
  void stop();

  /// The robot was moved.
  void moved(const Pose& from, const Pose& to);

  /// True while a goal is under way.
  [[nodiscard]] bool driving() const { return driving_; }
  /// Metres to go, >= 0; 0 for turns on the spot and without a goal.
  [[nodiscard]] double remaining() const;
  /// What the person is to do now.
  [[nodiscard]] Instruction instruction() const;

 private:
  /// Distance or angle of a goal, signed as the goal's.
  struct Part {
    double wanted = 0.0;
    double left = 0.0;

    [[nodiscard]] double to_go() const;  ///< >= 0
  };

  void settle();

  Twist twist_;  ///< Of set_speed(); of a goal its speed, forward or turning.
  bool driving_ = false;
  bool chained_ = false;  ///< `end_` is where the next goal begins.
  Pose end_;              ///< Where the last goal was to end.
  Part distance_;
  Part angle_;
  int commands_ = 0;
};

}  // namespace eyebridge::hal
