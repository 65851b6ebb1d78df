#pragma once

#include "eyebridge/camera/calibration.hpp"
#include "eyebridge/camera/frame.hpp"
#include "optics/eye_pose.hpp"

namespace eyebridge::camera::testing {

/// What a lens, distortion included, sees of a printed page that stands upright on the plane y = 0
/// of the world with its middle at (0, 0, 0), facing south; white round about. Grey8.
Frame look_at_page(const Frame& page, double pixels_per_mm, const Calibration& lens,
                   const EyePose& eye);

}  // namespace eyebridge::camera::testing
