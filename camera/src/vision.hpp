#pragma once

#include "eyebridge/camera/fiducials.hpp"

namespace eyebridge::camera {

/// All that needs OpenCV, behind one table: implemented in ../vision, a library that is opened when
/// it is first asked for, so that programs which see no fiducials load no OpenCV. Any thread.
class Vision {
 public:
  virtual ~Vision() = default;

  /// As fiducial_bits().
  [[nodiscard]] virtual FiducialBits fiducial_bits(int id) const = 0;
};

/// The vision library, opened once. Throws ConfigError when it cannot be.
const Vision& vision();

/// What that library exports, as "eyebridge_vision".
using VisionEntry = const Vision*();

}  // namespace eyebridge::camera
