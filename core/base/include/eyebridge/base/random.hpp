#pragma once

#include <cstdint>

namespace eyebridge {

/// A stream of random numbers that is the same on every machine for the same seed.
///
/// xoshiro256++ (Blackman and Vigna 2019), seeded through SplitMix64. One stream per robot and
/// device, so that adding a sensor does not change another one's noise. Not thread-safe.
class Random {
 public:
  /// `stream` tells streams of one seed apart.
  explicit Random(std::uint64_t seed, std::uint64_t stream = 0);

  /// 64 random bits.
  std::uint64_t bits();
  /// Evenly spread in [0, 1).
  double uniform();
  /// Normally distributed, mean 0, standard deviation 1 (inverse of the distribution, Wichura's
  /// AS 241, so that one number costs exactly one draw).
  double gaussian();
  /// True with probability `p`.
  bool chance(double p) { return uniform() < p; }

 private:
  std::uint64_t state_[4];
};

}  // namespace eyebridge
