#pragma once

#include <cstdint>

#include "eyebridge/base/random.hpp"
#include "eyebridge/robot/robot_model.hpp"

namespace eyebridge::robot {

/// What kind of device a stream of random numbers belongs to.
enum class NoiseSource : std::uint64_t {
  Drive,
  Range,
  Proximity,
  Bumper,
  Lidar,
  Compass,
  Camera,
  Slip,
  Encoder,
  Gyroscope,
  Accelerometer,
  RangeMatrix
};

/// The stream of device number `index` of kind `source` on robot `robot`: no two devices share
/// one, so that adding a sensor does not change another one's noise. `index` < 2^16.
Random noise_stream(std::uint64_t seed, std::uint32_t robot, NoiseSource source, std::size_t index);

/// `value` as a sensor with `error` reads it. Draws one number, or none when there is no sigma.
double with_error(double value, const GaussianError& error, Random& random);

}  // namespace eyebridge::robot
