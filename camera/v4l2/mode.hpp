#pragma once

#include <string>
#include <vector>

#include "v4l2/camera_url.hpp"
#include "v4l2/offers.hpp"
#include "v4l2/raw_formats.hpp"

namespace eyebridge::camera {

/// How a camera is to send frames.
struct Mode {
  std::uint32_t fourcc = 0;
  RawFormat format{};
  Size size;
  double fps = 0.0;  ///< Frames a second to ask for; 0: what it comes with.
  int stride = 0;    ///< Bytes a row, once the driver has said so.

  friend bool operator==(const Mode&, const Mode&) = default;
};

/// The mode that `wanted` asks for, or the best for a robot: 640x480 or what is nearest, the first
/// format in the order of kRawFormats that reaches 30 frames a second, else the fastest. Only
/// formats that are read count; there must be one. Throws ConfigError for a format, size or rate
/// that is not offered, with those that are.
Mode choose_mode(const VideoHandle& camera, const std::vector<OfferedFormat>& offers,
                 const CameraUrl& wanted);

/// Makes the driver send `mode`, and returns it as the driver has it. Throws ConfigError: when it
/// is in use, refuses, or would send something else.
Mode set_mode(const VideoHandle& camera, Mode mode, bool rate_matters);

/// "YUYV, MJPEG and H264"
std::string listed_formats(const std::vector<OfferedFormat>& offers);

/// "640x480"
std::string to_text(Size size);
/// "30", "29.97"
std::string rate_text(double fps);

}  // namespace eyebridge::camera
