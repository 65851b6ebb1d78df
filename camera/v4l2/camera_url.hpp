#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "eyebridge/camera/frame.hpp"

namespace eyebridge::camera {

/// What "v4l2:…" asks for.
struct CameraUrl {
  std::string device;                 ///< As written; "": the first camera.
  std::optional<Size> size;           ///< Pixels.
  std::optional<double> fps;          ///< Frames a second.
  std::optional<std::string> format;  ///< "YUYV", "MJPEG", "RGB24", "GREY", "NV12"
  std::map<std::string, std::string, std::less<>> controls;  ///< All other options.
};

/// Parses what follows "v4l2:": "/dev/video0?size=640x480&fps=30&format=YUYV&exposure_auto=1".
/// Throws ConfigError{"--camera"}; whether the device has all that is not known yet.
CameraUrl parse_camera_url(std::string_view rest);

}  // namespace eyebridge::camera
