#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "eyebridge/camera/frame.hpp"

namespace eyebridge::camera {

/// Frame sizes that a camera has in one format: one, or all from `least` to `most` in steps.
struct OfferedSize {
  Size least;
  Size most;                  ///< The same as `least` where there is one only.
  Size step;                  ///< Pixels; each at least 1.
  std::vector<double> rates;  ///< Frames a second, highest first; empty where the driver is silent.

  [[nodiscard]] bool is_range() const { return least != most; }
  [[nodiscard]] bool has(Size size) const;
  /// The one of these sizes that is nearest to `size`.
  [[nodiscard]] Size nearest(Size size) const;

  friend bool operator==(const OfferedSize&, const OfferedSize&) = default;
};

/// A format that a camera has.
struct OfferedFormat {
  std::uint32_t fourcc = 0;  ///< V4L2's.
  std::string name;          ///< "YUYV"
  bool is_read = false;      ///< EyeBridge reads it without libv4l's conversion.
  std::vector<OfferedSize> sizes;

  friend bool operator==(const OfferedFormat&, const OfferedFormat&) = default;
};

/// What a /dev/video* is for.
enum class DeviceKind {
  Camera,    ///< Gives frames.
  Metadata,  ///< Gives what a camera says about its frames; a camera is beside it.
  Other,     ///< An output, an encoder, a radio, …
  Unknown,   ///< It could not be asked.
};

/// A /dev/video* of this machine.
struct CameraDevice {
  std::string path;    ///< "/dev/video0"
  std::string by_id;   ///< Its link in /dev/v4l/by-id, which stays the same when replugged; or "".
  std::string card;    ///< "HD Webcam C525"; what the driver calls it.
  std::string parent;  ///< The device in /sys that it is a part of; "" when there is none.
  DeviceKind kind = DeviceKind::Unknown;
  int error = 0;                       ///< The errno with which opening failed; else 0.
  std::vector<OfferedFormat> formats;  ///< Of a Camera that could be opened.
};

/// All /dev/video* below `root`, by number, each opened for a moment; nothing is changed. Where one
/// cannot be opened, what udev and /sys below `root` know is told. Any thread.
std::vector<CameraDevice> list_cameras(const std::filesystem::path& root = "/");

}  // namespace eyebridge::camera
