#pragma once

#include <string>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge::camera {

/// "--camera: /dev/video0: it …"
ConfigError camera_error(const std::string& path, const std::string& text);

/// Why opening `path` failed with `number`, and what to do.
ConfigError open_error(const std::string& path, int number);

/// Why `what`, something done to an open camera, failed with `number`.
ConfigError call_error(const std::string& path, const std::string& what, int number);

}  // namespace eyebridge::camera
