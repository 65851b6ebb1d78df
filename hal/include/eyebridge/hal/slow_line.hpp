#pragma once

#include <algorithm>

#include "eyebridge/base/clock.hpp"

namespace eyebridge::hal {

// How v-omega on the host drives a board by encoders that are read over its line.

/// Between two counts nobody knows where the robot is: over a slow line it drives slower.
inline constexpr double kFarthestBlind = 0.025;  // metres
inline constexpr double kWidestBlind = 0.6;      // radians
/// Beyond, the drive would steer by what the robot did long ago: it refuses.
inline constexpr Time kLongestCycle = std::chrono::milliseconds(300);

/// What to expect of a line.
struct LineOutlook {
  Time cycle{0};           ///< Both counts, one behind the other.
  double top_speed = 0.0;  ///< m/s
  double off = 0.0;        ///< Metres, at the end of 500 mm.
  double turned = 0.0;     ///< Degrees, at the end of a turn of 90.
  bool drives = false;     ///< False: it refuses.
};

/// Of a line whose answers usually take `answer`, for a robot that could drive at `top_speed`. The
/// accuracy is that of the worst runs in docs/parity.md.
inline LineOutlook outlook(Time answer, double top_speed) {
  constexpr double kOffAtOnce = 0.0015;   // metres
  constexpr double kOffPerSecond = 0.14;  // metres a second of waiting
  constexpr double kTurnedAtOnce = 0.3;
  constexpr double kTurnedPerSecond = 57.0;
  LineOutlook out;
  out.cycle = std::max<Time>(std::chrono::milliseconds(10), 2 * answer);
  out.top_speed = std::min(top_speed, kFarthestBlind / to_seconds(out.cycle));
  out.off = kOffAtOnce + kOffPerSecond * to_seconds(answer);
  out.turned = kTurnedAtOnce + kTurnedPerSecond * to_seconds(answer);
  out.drives = out.cycle <= kLongestCycle;
  return out;
}

}  // namespace eyebridge::hal
