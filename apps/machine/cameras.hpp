#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "device_access.hpp"
#include "eyebridge/camera/devices.hpp"
#include "finding.hpp"
#include "system_files.hpp"

namespace eyebridge::apps {

/// A /dev/video*, who may use it and who does.
struct Camera {
  camera::CameraDevice device;
  DeviceAccess access;
  std::vector<Process> holders;  ///< Who has it open.
};

/// Looks at the cameras below `root`. Changes nothing; each is opened for a moment.
std::vector<Camera> look_at_cameras(const std::filesystem::path& root = "/");

/// One finding for all cameras and one more for each device.
std::vector<Finding> judge_cameras(const std::vector<Camera>& cameras);

/// The table of `eyebridge camera list`: names, cards, formats with sizes and rates, users.
std::string table_of(const std::vector<Camera>& cameras);

}  // namespace eyebridge::apps
