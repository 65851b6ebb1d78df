#pragma once

#include <string>
#include <string_view>

#include "eyebridge/camera/calibration.hpp"

namespace eyebridge::camera {

/// Whether `text` is a calibration as ROS (`ost.yaml`, camera_info) or OpenCV (FileStorage: YAML
/// or XML) writes it.
bool is_yaml_calibration(std::string_view text);

/// Reads one. Throws ConfigError with line and column.
Calibration parse_yaml_calibration(std::string_view text, const std::string& file);

}  // namespace eyebridge::camera
