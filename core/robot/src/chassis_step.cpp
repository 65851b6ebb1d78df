#include <cmath>

#include "simulation_impl.hpp"

// A step of robots that are no differential ones: the same stages as in step.cpp, written for any
// number of wheels, and anew in each step.

namespace eyebridge::robot {
namespace {

constexpr double kStill = 1e-9;  // metres per second: a lagging motor has run down

bool has_nothing_to_do(RobotState& state) {
  Chassis& chassis = *state.chassis;
  state.driven_before = state.driven;
  state.driven_left_before = state.driven_left;
  const bool commanded = state.by_motors ? chassis.is_commanded() : !state.controller.at_rest();
  if (commanded || !chassis.is_settled() || !chassis.stands(kStill)) return false;
  chassis.halt();
  state.driven = {};
  state.driven_left = 0.0;
  state.measured = {};
  return true;
}

Rims drive_chassis(RobotState& state) {
  Chassis& chassis = *state.chassis;
  if (state.by_motors) return chassis.run();
  const Twist twist =
      state.controller.next(state.motor.time_constant > 0.0 ? state.rolling() : PathStep{});
  return chassis.follow(state.controller, twist);
}

/// How far the ground lets the rims go.
Rims held_by_ground(RobotState& state, Rims rims) {
  const DriveError& error = state.error;
  const std::vector<ChassisWheel>& wheels = state.chassis->wheels();
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    if (!state.chassis->is_held(i)) continue;  // it does not roll
    const double side = wheels[i].side;
    rims[i] *= 1.0 + (error.left_scale * (1.0 + side) + error.right_scale * (1.0 - side)) / 2;
    if (error.slip > 0.0 && state.faults->slips(error.slip, i)) rims[i] = 0.0;
  }
  return rims;
}

Ground ground_of(RobotState& state) {
  const DriveError& error = state.error;
  Ground ground;
  if (error.linear_sigma != 0.0) ground.way += error.linear_sigma * state.noise.gaussian();
  if (error.angular_sigma != 0.0) ground.turn += error.angular_sigma * state.noise.gaussian();
  ground.uneven = error.right_scale - error.left_scale;
  return ground;
}

/// Turns the wheels by `rims`, and their encoders as far as those see it.
void turn_wheels(RobotState& state, const Rims& rims, bool held) {
  std::vector<ChassisWheel>& wheels = state.chassis->wheels();
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    ChassisWheel& w = wheels[i];
    const bool stops = held && state.chassis->is_held(i);
    if (state.error.encoder_miss == 0.0) {
      w.wheel.turn(rims[i], stops, w.motor);
      continue;
    }
    const std::int64_t before = w.wheel.raw_ticks(w.motor);
    w.wheel.turn(rims[i], stops, w.motor);
    const std::int64_t ticks = w.wheel.raw_ticks(w.motor) - before;
    w.wheel.miss(state.faults->missed(state.error.encoder_miss, i, ticks));
  }
}

/// What odometry sees of the wheels' travel.
BodyStep measured_step(RobotState& state, const Rims& rims) {
  if (!state.error.counts_ticks()) return state.chassis->seen(rims);
  std::vector<ChassisWheel>& wheels = state.chassis->wheels();
  Rims seen{};
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    ChassisWheel& w = wheels[i];
    const std::int64_t ticks = w.wheel.raw_ticks(w.motor);
    seen[i] = static_cast<double>(ticks - w.seen_ticks) / w.motor.ticks_per_metre;
    w.seen_ticks = ticks;
  }
  return state.chassis->seen(seen);
}

}  // namespace

void Simulation::Impl::step_chassis(RobotState& state) {
  if (has_nothing_to_do(state)) return;
  Chassis& chassis = *state.chassis;
  Rims rims = drive_chassis(state);
  const Rims hold = held_by_ground(state, rims);
  const Ground ground = ground_of(state);
  const BodyStep step = chassis.ground(hold, ground);
  const world::MoveResult result =
      step == BodyStep{} ? world::MoveResult{}
                         : world.move(state.body, screw_of(step), settings.step, state.contact);
  const bool held = result.blocked() && !result.slid;
  const bool turns = state.contact.turns;
  if (result.blocked()) rims = chassis.blocked(rims, result.progress);
  turn_wheels(state, rims, held);
  chassis.settle(rims, ground, held);
  const BodyStep measured = measured_step(state, rims);
  state.odometry.add(screw_of(measured));
  const double per_second = result.progress / settings.step;
  state.driven = {step.forward * per_second,
                  step.angle * (turns ? 1.0 / settings.step : per_second)};
  state.driven_left = step.left * per_second;
  const PathStep path{measured.forward, measured.angle};
  state.measured = {path.distance / settings.step, path.angle / settings.step};
  if (!state.by_motors) {
    if (held || chassis.is_stuck()) {
      state.controller.hold(path, turns);
    } else {
      state.controller.advance(path);
    }
    chassis.go_on(state.controller);
  }
  account(state, held || chassis.is_stuck());
}

}  // namespace eyebridge::robot
