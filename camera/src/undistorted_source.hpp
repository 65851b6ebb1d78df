#pragma once

#include <memory>
#include <optional>
#include <string>

#include "eyebridge/camera/calibration.hpp"
#include "eyebridge/camera/source.hpp"

namespace eyebridge::camera {

/// The option that every source's URL may have, "calibration=FILE", and the URL without it.
struct CalibratedUrl {
  std::string url;
  std::optional<std::string> file;
};

/// Throws ConfigError at "--camera" when the option is empty or given twice.
CalibratedUrl take_calibration(const std::string& url);

/// `inner` as if its lens were a pinhole, by the calibration in `file`. Throws ConfigError for a
/// bad file, or one for pictures of another aspect than `inner` has.
std::unique_ptr<Source> undistort(std::unique_ptr<Source> inner, const std::string& file);

}  // namespace eyebridge::camera
