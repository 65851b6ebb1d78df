#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "eyebridge/base/pose.hpp"

namespace eyebridge::bench {

/// The controller that all peers were measured with: straight on at 0.3 m/s; nearer than 0.5 m to
/// something in the front 90 degrees it turns to the freer side for 0.5 … 1.4 s. One decision each
/// tenth of a second.
class Wander {
 public:
  /// The same numbers for the same `robot`, as from the peers' controllers.
  explicit Wander(std::uint32_t robot) : state_((robot + 1) * 2654435761U + 12345U) {}

  /// `ranges`, metres, clockwise all round from straight behind, a multiple of 8 of them.
  Twist steer(std::span<const double> ranges) {
    if (turning_ > 0) {
      --turning_;
      return {0.0, side_};
    }
    const std::size_t ahead = ranges.size() / 2;
    const std::size_t eighth = ranges.size() / 8;
    const auto nearest = [&](std::size_t first, std::size_t last) {
      double range = ranges[first];
      for (std::size_t i = first + 1; i <= last; ++i) range = std::min(range, ranges[i]);
      return range;
    };
    if (nearest(ahead - eighth, ahead + eighth) >= 0.5) return {0.3, 0.0};
    const double left = nearest(ahead - 2 * eighth, ahead - 1);
    const double right = nearest(ahead + 1, ahead + 2 * eighth);
    side_ = left < right ? -1.0 : 1.0;
    turning_ = 5 + static_cast<int>(random() % 10);
    return {0.0, side_};
  }

  /// Without looking: another curve every two seconds.
  Twist blind() {
    if (ticks_++ % 20 == 0) side_ = 0.5 * (static_cast<int>(random() % 3) - 1);
    return {0.3, side_};
  }

 private:
  std::uint32_t random() {
    state_ = state_ * 1664525U + 1013904223U;  // Numerical Recipes' generator
    return state_ >> 16U;
  }

  std::uint32_t state_;
  int turning_ = 0;  // ticks that are left of a turn
  unsigned ticks_ = 0;
  double side_ = 0.0;  // of the turn, radians per second
};

}  // namespace eyebridge::bench
