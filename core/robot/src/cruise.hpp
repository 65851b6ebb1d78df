#pragma once

#include <vector>

#include "robot_state.hpp"

namespace eyebridge::robot {

/// What a robot needs for steps in which nothing changes but where it is: two cache lines instead
/// of a dozen.
///
/// While it is `steady`, its numbers here go on and those in its RobotState stay behind; Cruise::
/// give_back() brings them up to date. One that is `pressed` against something it cannot move, and
/// tries the same again and again, only waits for the way to become free.
struct alignas(64) Cruise {
  Odometry odometry;
  world::Arc arc;             ///< Of each step.
  WheelTravel wheels;         ///< In each step.
  std::array<double, 2> sum;  ///< Of the wheels since the start, metres.
  double angle = 0.0;         ///< Of each step, radians.
  double owed = 0.0;          ///< DriveController::heading_owed().
  world::BodyId body = world::kNoBody;
  bool steady = false;
  bool pressed = false;
  bool stall_known = false;  ///< By the RobotState of a pressed one.
  bool ahead = false;        ///< Of the RobotState.

  /// Takes over from `state`, whose next step will be like the one that it just did.
  void take(const RobotState& state) {
    odometry = state.odometry;
    arc = state.plan.arc;
    wheels = state.plan.wheels;
    sum = {state.wheels[0].travel(), state.wheels[1].travel()};
    angle = state.plan.path.angle;
    owed = state.controller.heading_owed();
    steady = true;
  }

  /// One step that met nothing: what a robot's whole pipeline does then.
  void advance() {
    sum[0] += wheels.left;
    sum[1] += wheels.right;
    odometry.add(arc);
    owed -= angle;
    ahead = true;
  }

  /// Likewise, after two steps in a row in which `state` could not move at all.
  void press(const RobotState& state) {
    odometry = state.odometry;
    arc = state.plan.arc;
    wheels = {};
    sum = {state.wheels[0].travel(), state.wheels[1].travel()};
    angle = 0.0;
    owed = state.controller.heading_owed();
    pressed = true;
    stall_known = true;
  }

  /// One more of these: the numbers stay, but for the last bit of a heading.
  void wait() {
    odometry.add({});
    ahead = true;
  }

  void give_back(RobotState& state) {
    if (!ahead) return;
    state.odometry = odometry;
    state.wheels[0].set_travel(sum[0]);
    state.wheels[1].set_travel(sum[1]);
    state.controller.set_heading_owed(owed);
    state.driven_before = state.driven;
    ahead = false;
  }
};

}  // namespace eyebridge::robot
