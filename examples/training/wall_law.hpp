#pragma once

#include <algorithm>

/// How to follow a wall on the right, in six numbers: what evolves. The same law steers in training
/// and in the robot program. Metres, radians, seconds.
struct WallLaw {
  static constexpr int kGenes = 6;
  static constexpr double kPeriod = 0.1;  ///< Between two commands.
  static constexpr const char* kNames[kGenes] = {"keep",  "gain",       "damping",
                                                 "speed", "front_stop", "turn"};
  static constexpr double kLow[kGenes] = {0.03, 0.0, 0.0, 0.05, 0.02, 0.2};
  static constexpr double kHigh[kGenes] = {0.40, 15.0, 10.0, 0.50, 0.60, 4.0};

  double genes[kGenes] = {};

  struct Command {
    double linear = 0;
    double angular = 0;
  };

  /// `front` and `side` are ranges ahead and to the right, `last_side` that of the command before.
  [[nodiscard]] Command steer(double front, double side, double last_side) const {
    const auto [keep, gain, damping, speed, front_stop, turn] = genes;
    if (front < front_stop) return {speed / 4, turn};
    const double seen = std::min(side, 2 * keep + 0.1);  // an opening is no wall far away
    const double before = std::min(last_side, 2 * keep + 0.1);
    const double wanted = gain * (keep - seen) - damping * (seen - before);
    return {speed, std::clamp(wanted, -turn, turn)};
  }
};
