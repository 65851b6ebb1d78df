#pragma once

#include <array>
#include <cstdint>

#include "eyebridge/base/random.hpp"

namespace eyebridge::robot {

/// No drive has more.
inline constexpr std::size_t kMostWheels = 4;

/// Faults that wheels and encoders have now and then; each wheel draws from streams of its own.
class DriveFaults {
 public:
  /// Of robot number `robot` in a run with `seed`.
  DriveFaults(std::uint64_t seed, std::uint32_t robot);

  /// True when wheel `wheel` finds no hold in this step, with `probability`.
  bool slips(double probability, std::size_t wheel);
  /// How many of the `ticks` of wheel `side` (0 left, 1 right …) are not counted, each with
  /// `probability`; signed as `ticks`.
  std::int64_t missed(double probability, std::size_t side, std::int64_t ticks);

 private:
  std::array<Random, kMostWheels> slip_;
  std::array<Random, kMostWheels> encoder_;
};

}  // namespace eyebridge::robot
