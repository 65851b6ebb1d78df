#include <array>
#include <cmath>
#include <cstring>

#include "simulation_impl.hpp"

namespace eyebridge::robot {
namespace {

constexpr double kStanding = 1e-9;  // metres per second: a lagging motor has run down

bool nothing_to_do(RobotState& state) {
  const bool commanded = state.by_motors
                             ? state.commands[0].speed != 0.0 || state.commands[1].speed != 0.0
                             : !state.controller.at_rest();
  if (commanded) return false;
  for (const Wheel& wheel : state.wheels) {
    if (std::abs(wheel.speed()) > kStanding) return false;
  }
  for (Wheel& wheel : state.wheels) wheel.halt();
  state.driven_before = state.driven;
  state.driven = {};
  state.measured = {};
  return true;
}

WheelTravel drive_wheels(RobotState& state) {
  auto& [left, right] = state.wheels;
  if (state.by_motors) {
    const auto run = [&](Wheel& wheel, const MotorCommand& command) {
      return command.controlled ? wheel.drive_controlled(command.speed, state.motor)
                                : wheel.drive(command.speed, state.motor);
    };
    return {run(left, state.commands[0]), run(right, state.commands[1])};
  }
  const Twist twist =
      state.controller.next(state.motor.time_constant > 0.0 ? state.rolling() : PathStep{});
  const double turning = twist.angular * state.controller.limits().half_base;
  return {left.drive_controlled(twist.linear - turning, state.motor),
          right.drive_controlled(twist.linear + turning, state.motor)};
}

bool same_bits(const PathStep& a, const PathStep& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

/// What the ground makes of the wheels' travel.
PathStep true_path(RobotState& state, const WheelTravel& wheels) {
  const DriveError& error = state.error;
  WheelTravel ground{wheels.left * (1.0 + error.left_scale),
                     wheels.right * (1.0 + error.right_scale)};
  if (error.slip > 0.0) state.faults->slip(error.slip, ground);
  PathStep path = path_of(ground, state.wheel_base);
  if (error.linear_sigma != 0.0) path.distance *= 1.0 + error.linear_sigma * state.noise.gaussian();
  if (error.angular_sigma != 0.0) path.angle *= 1.0 + error.angular_sigma * state.noise.gaussian();
  return path;
}

/// Turns wheel `side` by `travel`, and its encoder as far as that sees it.
void turn_wheel(RobotState& state, std::size_t side, double travel, bool held) {
  Wheel& wheel = state.wheels[side];
  if (state.error.encoder_miss == 0.0) {
    wheel.turn(travel, held, state.motor);
    return;
  }
  const std::int64_t before = wheel.raw_ticks(state.motor);
  wheel.turn(travel, held, state.motor);
  const std::int64_t ticks = wheel.raw_ticks(state.motor) - before;
  wheel.miss(state.faults->missed(state.error.encoder_miss, side, ticks));
}

/// What odometry sees of the wheels' travel.
PathStep measured_path(RobotState& state, const WheelTravel& wheels) {
  if (!state.error.counts_ticks()) return path_of(wheels, state.wheel_base);
  double travel[2];
  for (std::size_t i = 0; i < 2; ++i) {
    const std::int64_t ticks = state.wheels[i].raw_ticks(state.motor);
    travel[i] = static_cast<double>(ticks - state.seen_ticks[i]) / state.motor.ticks_per_metre;
    state.seen_ticks[i] = ticks;
  }
  return path_of({travel[0], travel[1]}, state.wheel_base);
}

void make_plan(RobotState& state) {
  const std::array<double, 2> speeds{state.wheels[0].speed(), state.wheels[1].speed()};
  state.plan.wheels = drive_wheels(state);
  const PathStep path = true_path(state, state.plan.wheels);
  // Robots drive on as they did, mostly.
  if (!same_bits(path, state.plan.path)) {
    state.plan.path = path;
    state.plan.arc = arc_of(path);
  }
  state.steady = state.repeats(speeds);
}

}  // namespace

void Simulation::Impl::step_robot(RobotIndex robot) {
  Cruise& cruise = cruises[robot];
  if (cruise.steady) {
    const world::MoveResult result =
        world.move(cruise.body, cruise.arc, settings.step, states[robot].contact);
    if (!result.blocked()) {
      cruise.advance();
      return;
    }
    finish_step(robot, command(robot), result);
    return;
  }
  if (cruise.pressed) {
    const world::MoveResult result =
        world.move(cruise.body, cruise.arc, settings.step, states[robot].contact);
    if (result.progress == 0.0 && !result.slid) {
      cruise.wait();
      if (!cruise.stall_known) states[robot].stalled = kStallBoth;
      cruise.stall_known = true;
      return;
    }
    RobotState& freed = command(robot);
    make_plan(freed);
    finish_step(robot, freed, result);
    return;
  }
  RobotState& state = states[robot];
  if (state.chassis) [[unlikely]] {
    if (!state.has_left) step_chassis(state);
    return;
  }
  if (!state.steady) {
    if (state.has_left) return;
    if (nothing_to_do(state)) return;
    make_plan(state);
  }
  const PathStep& path = state.plan.path;
  const bool moves = path.distance != 0.0 || path.angle != 0.0;
  finish_step(robot, state,
              moves ? world.move(state.body, state.plan.arc, settings.step, state.contact)
                    : world::MoveResult{});
}

void Simulation::Impl::finish_step(RobotIndex robot, RobotState& state,
                                   const world::MoveResult& result) {
  const StepPlan& plan = state.plan;
  const bool blocked = result.blocked();
  const bool held = blocked && !result.slid;
  state.steady = state.steady && !blocked;
  WheelTravel wheels = plan.wheels;
  if (blocked) {
    // The wheels go on with what turns the robot, and with as much of the way as it makes.
    const double lost = (1.0 - result.progress) * (wheels.left + wheels.right) / 2;
    wheels = {wheels.left - lost, wheels.right - lost};
  }
  turn_wheel(state, 0, wheels.left, held);
  turn_wheel(state, 1, wheels.right, held);
  const PathStep measured = measured_path(state, wheels);
  state.odometry.add(measured == plan.path ? plan.arc : arc_of(measured));
  const double dt = settings.step;
  state.driven_before = state.driven;
  state.driven = {plan.path.distance * result.progress / dt, plan.path.angle / dt};
  state.measured = {measured.distance / dt, measured.angle / dt};
  if (!state.by_motors) {
    if (held) {
      state.controller.hold(measured, true);
    } else {
      state.controller.advance(measured);
    }
  }
  account(state, held);
  const bool stuck = held && result.progress == 0.0 && plan.path.angle == 0.0;
  if (state.cruises(measured)) cruises[robot].take(state);
  if (stuck && state.presses()) cruises[robot].press(state);
  state.held_before = stuck;
}

void Simulation::Impl::account(RobotState& state, bool held) {
  if (!held) {
    state.clear_stall();
    return;
  }
  state.stalled = kStallBoth;
  if (state.stalled_steps < stall_timeout_steps) ++state.stalled_steps;
  if (!state.by_motors && state.controller.state() == DriveState::Driving &&
      state.stalled_steps >= stall_timeout_steps) {
    state.controller.fail();
  }
}

}  // namespace eyebridge::robot
