#pragma once

#include <cstdint>

#include "eyebridge/robot/odometry.hpp"

namespace eyebridge::robot {

/// A cache in front of the pipeline: what a robot needs for steps in which nothing changes but
/// where it is, in two cache lines instead of a dozen.
///
/// It moves the body and counts the steps. Wheels and controller stay behind until somebody asks:
/// Simulation::Impl::catch_up(). Odometry goes along, for its sum is the one thing that takes time,
/// and none beside the move: later it made a step 15 % slower (bench_scale, psd, 10 ms).
struct alignas(64) Cruise {
  enum class Mode : std::uint8_t {
    Off,      ///< Each step goes through the pipeline.
    Steady,   ///< The last step is done again and again.
    Pressed,  ///< It pushes against something that it cannot move, until its way is free.
  };

  world::Arc arc;             ///< Of each step.
  Odometry odometry;          ///< The RobotState's, unless Off.
  world::ContactLaw contact;  ///< Of each move, in any mode.
  std::uint64_t steps = 0;    ///< That the RobotState does not know of yet.
  world::BodyId body = world::kNoBody;
  Mode mode = Mode::Off;

  void start(Mode how, const world::Arc& each, const Odometry& before) {
    mode = how;
    arc = each;
    odometry = before;
  }

  /// Whether a step that ended so was like the one before; then it is counted.
  bool takes(const world::MoveResult& result) {
    const bool steady = mode == Mode::Steady;
    if (steady ? result.blocked() : result.progress != 0.0 || result.slid) return false;
    odometry.add(steady ? arc : world::Arc{});
    ++steps;
    return true;
  }
};
static_assert(sizeof(Cruise) == 128);

}  // namespace eyebridge::robot
