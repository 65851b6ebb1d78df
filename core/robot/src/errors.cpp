#include "errors.hpp"

#include <cmath>

namespace eyebridge::robot {

Random noise_stream(std::uint64_t seed, std::uint32_t robot, NoiseSource source,
                    std::size_t index) {
  const auto kind = static_cast<std::uint64_t>(source);
  return Random(seed, (std::uint64_t{robot} << 24U) | (kind << 16U) | index);
}

double with_error(double value, const GaussianError& error, Random& random) {
  const double sigma = error.sigma + error.sigma_relative * std::abs(value);
  const double noise = sigma != 0.0 ? sigma * random.gaussian() : 0.0;
  return value + error.bias + noise;
}

}  // namespace eyebridge::robot
