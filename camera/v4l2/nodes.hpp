#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "eyebridge/camera/devices.hpp"
#include "v4l2/video_handle.hpp"

namespace eyebridge::camera {

// Where cameras are found: /dev/video*, the links to them, and what /sys and udev know of them.
// `root` is the folder that counts as "/".

/// list_cameras() by `calls`.
std::vector<CameraDevice> list_cameras(VideoCalls& calls, const std::filesystem::path& root);

/// What an open device says it is.
struct Identity {
  DeviceKind kind = DeviceKind::Unknown;
  bool streams = false;  ///< It has buffers that can be mapped.
  std::string card;
  std::string bus;
};
/// Unknown for what is no V4L2 device.
Identity identity_of(const VideoHandle& device);

/// The path that `name`, as written in a URL, stands for: itself when it is one ("/dev/video0"),
/// else a link of that name in /dev/v4l/by-id or by-path, else a name in /dev. Throws ConfigError,
/// with the names there are, when it is none.
std::string path_of(const std::string& name, const std::filesystem::path& root);

/// The name to look for when the camera at `path` was unplugged: its link in /dev/v4l/by-id where
/// it has one, else `path`.
std::string lasting_name(const std::string& path, const std::filesystem::path& root);

}  // namespace eyebridge::camera
