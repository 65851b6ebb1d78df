#include <bit>
#include <cmath>
#include <cstdint>

#include "simulation_impl.hpp"

// The pipeline of a robot, from command to pose: run_pipeline() has its stages in their order.

namespace eyebridge::robot {
namespace {

constexpr double kStanding = 1e-9;  // metres per second: a lagging motor has run down

/// Whether nothing moves the robot: it stands, then.
template <class Drive>
bool rests(RobotState& state, Drive& chassis) {
  if (state.is_told_to_move() || !chassis.is_settled()) return false;
  for (const ChassisWheel& w : chassis.wheels()) {
    if (std::abs(w.wheel.speed()) > kStanding) return false;
  }
  chassis.halt();
  state.driven_before = state.driven;
  state.driven = {};
  state.measured = {};
  return true;
}

/// How far the rims go by the commands.
template <class Drive>
Rims drive_motors(RobotState& state, Drive& chassis) {
  if (state.by_motors) return chassis.run();
  const bool lags = chassis.wheels()[0].motor.time_constant > 0.0;
  const Twist twist = state.controller.next(lags ? chassis.rolling() : PathStep{});
  return chassis.follow(state.controller, twist);
}

/// How far the ground lets the rims go.
template <class Drive>
Rims held_by_ground(RobotState& state, Drive& chassis) {
  const auto wheels = chassis.wheels();
  Rims rims{};
  for (std::size_t i = 0; i < wheels.size(); ++i) rims[i] = state.plan.rims[i] * wheels[i].grip;
  if (state.error.slip > 0.0) {
    for (std::size_t i = 0; i < wheels.size(); ++i) {
      if (wheels[i].rolls && state.faults->slips(state.error.slip, i)) rims[i] = 0.0;
    }
  }
  return rims;
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// What the ground makes of the wheels.
template <class Drive>
void plan_arc(RobotState& state, Drive& chassis) {
  StepPlan& plan = state.plan;
  const Rims hold = held_by_ground(state, chassis);
  const DriveError& error = state.error;
  if (error.linear_sigma != 0.0)
    plan.ground.way = 1.0 + error.linear_sigma * state.noise.gaussian();
  if (error.angular_sigma != 0.0)
    plan.ground.turn = 1.0 + error.angular_sigma * state.noise.gaussian();
  const BodyStep step = chassis.ground(hold, plan.ground);
  // Robots drive on as they did, mostly.
  if (same_bits(step.forward, plan.step.forward) && same_bits(step.left, plan.step.left) &&
      same_bits(step.angle, plan.step.angle)) {
    return;
  }
  plan.step.forward = step.forward;
  plan.step.left = step.left;
  plan.step.angle = step.angle;
  plan.arc = screw_of(step);
}

/// Turns the wheels, and their encoders as far as those see it.
template <class Drive>
void turn_wheels(RobotState& state, Drive& chassis, bool held) {
  const auto wheels = chassis.wheels();
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    ChassisWheel& w = wheels[i];
    const bool stops = held && w.rolls;
    if (state.error.encoder_miss == 0.0) {
      w.wheel.turn(state.plan.rims[i], stops, w.motor);
      continue;
    }
    const std::int64_t before = w.wheel.raw_ticks(w.motor);
    w.wheel.turn(state.plan.rims[i], stops, w.motor);
    const std::int64_t ticks = w.wheel.raw_ticks(w.motor) - before;
    w.wheel.miss(state.faults->missed(state.error.encoder_miss, i, ticks));
  }
}

/// What odometry sees of the wheels' travel.
template <class Drive>
BodyStep measured_step(RobotState& state, Drive& chassis) {
  if (!state.error.counts_ticks()) return chassis.seen(state.plan.rims);
  const auto wheels = chassis.wheels();
  Rims seen{};
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    ChassisWheel& w = wheels[i];
    const std::int64_t ticks = w.wheel.raw_ticks(w.motor);
    seen[i] = static_cast<double>(ticks - w.seen_ticks) / w.motor.ticks_per_metre;
    w.seen_ticks = ticks;
  }
  return chassis.seen(seen);
}

/// Of the rims, metres per second.
template <class Drive>
Rims speeds_of(Drive& chassis) {
  const auto wheels = chassis.wheels();
  Rims speeds{};
  for (std::size_t i = 0; i < wheels.size(); ++i) speeds[i] = wheels[i].wheel.speed();
  return speeds;
}

/// True when the next step, unless a command comes or something is in the way, is like this one
/// and changes nothing but where the robot is. `speeds` are the rims' before it.
template <class Drive>
bool repeats(const RobotState& state, Drive& chassis, const Rims& speeds) {
  const bool same_command = state.by_motors || state.controller.settled();
  if (!same_command || state.error.moves_by_chance() || !chassis.repeats()) return false;
  const auto wheels = chassis.wheels();
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    if (!wheels[i].wheel.settled(speeds[i])) return false;
  }
  return state.is_told_to_move();
}

/// `use` of a robot's chassis. Most are differential ones: compiled for these, without virtual
/// calls, a whole step takes a sixth less time (bench_simulation, pipeline).
template <class Use>
void with_chassis(RobotState& state, const Use& use) {
  if (state.differential != nullptr) {
    use(*state.differential);
  } else {
    use(*state.chassis);
  }
}

}  // namespace

void Simulation::Impl::step_robot(RobotIndex robot) {
  Cruise& cruise = cruises[robot];
  if (cruise.mode != Cruise::Mode::Off) {
    const world::MoveResult met =
        world.move(cruise.body, cruise.arc, settings.step, cruise.contact);
    if (cruise.takes(met)) return;
    RobotState& state = command(robot);
    with_chassis(state, [&](auto& chassis) { run_pipeline(cruise, state, chassis, &met); });
    return;
  }
  RobotState& state = states[robot];
  if (state.has_left) return;
  with_chassis(state, [&](auto& chassis) {
    if (state.plan.repeats || !rests(state, chassis)) run_pipeline(cruise, state, chassis, nullptr);
  });
}

template <class Drive>
void Simulation::Impl::run_pipeline(Cruise& cruise, RobotState& state, Drive& chassis,
                                    const world::MoveResult* met) {
  StepPlan& plan = state.plan;
  if (!plan.repeats) {
    const Rims speeds = speeds_of(chassis);
    // Command -> ramps -> wheel targets (PID) -> motors -> wheels.
    plan.rims = drive_motors(state, chassis);
    // Wheels -> arc.
    plan_arc(state, chassis);
    plan.repeats = repeats(state, chassis, speeds);
  }
  // Arc -> collision -> pose.
  const bool moves = plan.step != BodyStep{};
  const world::MoveResult result =
      met != nullptr ? *met
      : moves        ? world.move(state.body, plan.arc, settings.step, cruise.contact)
                     : world::MoveResult{};
  const bool held = result.blocked() && !result.slid;
  if (result.blocked()) plan.rims = chassis.blocked(plan.rims, result.progress);
  state.driven_before = state.driven;
  state.driven = chassis.speed(plan.step, result.progress, settings.step);
  // Wheels -> encoders -> odometry -> controller, stalls.
  turn_wheels(state, chassis, held);
  chassis.settle(plan.rims, plan.ground, held);
  const BodyStep seen = measured_step(state, chassis);
  const bool as_planned = seen == plan.step;
  state.odometry.add(as_planned ? plan.arc : screw_of(seen));
  state.measured = {seen.forward / settings.step, seen.angle / settings.step};
  tell_controller(state, chassis, seen, held || chassis.is_stuck());
  // The next step: robots without a goal do the same again, mostly.
  const bool free = state.controller.state() != DriveState::Driving;
  plan.repeats = plan.repeats && free && !result.blocked();
  const bool stuck =
      held && result.progress == 0.0 && plan.step.angle == 0.0 && plan.rims == Rims{};
  if (plan.repeats && moves && as_planned && !state.error.counts_ticks()) {
    cruise.start(Cruise::Mode::Steady, plan.arc, state.odometry);
  } else if (stuck && state.held_before && free && state.is_told_to_move() && chassis.repeats() &&
             !state.error.moves_by_chance()) {
    cruise.start(Cruise::Mode::Pressed, plan.arc, state.odometry);
  }
  state.held_before = stuck;
}

template <class Drive>
void Simulation::Impl::tell_controller(RobotState& state, Drive& chassis, const BodyStep& seen,
                                       bool stalls) {
  if (!state.by_motors) {
    const PathStep path{seen.forward, seen.angle};
    if (stalls) {
      state.controller.hold(path, chassis.can_turn_on_spot());
    } else {
      state.controller.advance(path);
    }
    chassis.go_on(state.controller);
  }
  if (!stalls) {
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

void Simulation::Impl::catch_up(RobotIndex robot) {
  Cruise& cruise = cruises[robot];
  RobotState& state = states[robot];
  state.odometry = cruise.odometry;
  state.driven_before = state.driven;
  if (cruise.mode == Cruise::Mode::Pressed) {
    cruise.steps = 0;
    state.stalled = kStallBoth;
    return;
  }
  // One by one, for the sums to be the same to the bit.
  const std::span<ChassisWheel> wheels = state.chassis->wheels();
  Rims travel{};
  for (std::size_t i = 0; i < wheels.size(); ++i) travel[i] = wheels[i].wheel.travel();
  double owed = state.controller.heading_owed();
  for (; cruise.steps > 0; --cruise.steps) {
    for (std::size_t i = 0; i < travel.size(); ++i) travel[i] += state.plan.rims[i];
    owed -= state.plan.step.angle;
  }
  for (std::size_t i = 0; i < wheels.size(); ++i) wheels[i].wheel.set_travel(travel[i]);
  if (!state.by_motors) state.controller.set_heading_owed(owed);
}

}  // namespace eyebridge::robot
