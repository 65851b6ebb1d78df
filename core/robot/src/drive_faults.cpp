#include "drive_faults.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "errors.hpp"

namespace eyebridge::robot {
namespace {

constexpr std::int64_t kDrawnOneByOne = 256;

/// How many of `count` events happen, each with probability `p`.
std::int64_t binomial(std::int64_t count, double p, Random& random) {
  if (count > kDrawnOneByOne) {
    // By the normal distribution that it is close to; a step with so many ticks is rare.
    const auto mean = static_cast<double>(count) * p;
    const double drawn = mean + std::sqrt(mean * (1.0 - p)) * random.gaussian();
    return std::llround(std::clamp(drawn, 0.0, static_cast<double>(count)));
  }
  std::int64_t happened = 0;
  for (std::int64_t i = 0; i < count; ++i) happened += random.chance(p) ? 1 : 0;
  return happened;
}

/// One stream a wheel.
std::array<Random, kMostWheels> streams(std::uint64_t seed, std::uint32_t robot,
                                        NoiseSource source) {
  const auto stream = [&](std::size_t wheel) { return noise_stream(seed, robot, source, wheel); };
  return {stream(0), stream(1), stream(2), stream(3)};
}

}  // namespace

DriveFaults::DriveFaults(std::uint64_t seed, std::uint32_t robot)
    : slip_(streams(seed, robot, NoiseSource::Slip)),
      encoder_(streams(seed, robot, NoiseSource::Encoder)) {}

bool DriveFaults::slips(double probability, std::size_t wheel) {
  return slip_[wheel].chance(probability);
}

std::int64_t DriveFaults::missed(double probability, std::size_t side, std::int64_t ticks) {
  const std::int64_t count = binomial(std::abs(ticks), probability, encoder_[side]);
  return ticks < 0 ? -count : count;
}

}  // namespace eyebridge::robot
