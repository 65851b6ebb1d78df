#pragma once

#include <memory>
#include <string>

#include "eyebridge/camera/calibration.hpp"
#include "eyebridge/camera/source.hpp"

namespace eyebridge::camera {

/// `inner` as if its lens were a pinhole, by the calibration in `file`. Throws ConfigError for a
/// bad file, or one for pictures of another aspect than `inner` has.
std::unique_ptr<Source> undistort(std::unique_ptr<Source> inner, const std::string& file);

}  // namespace eyebridge::camera
