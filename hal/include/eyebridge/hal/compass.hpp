#pragma once

#include "eyebridge/base/result.hpp"

namespace eyebridge::hal {

/// Heading in the world.
class Compass {
 public:
  virtual ~Compass() = default;

  /// Radians counter-clockwise from the world's +x axis, (-pi, pi].
  virtual Result<double> read() = 0;
};

}  // namespace eyebridge::hal
