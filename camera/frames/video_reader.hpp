#pragma once

#include <cstdint>
#include <optional>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/camera/frame.hpp"

namespace eyebridge::camera {

/// A video file, read from its start to its end. Implemented in libeyebridge_video.so, the only
/// place that needs OpenCV's videoio; nothing of OpenCV shows here. One thread at a time.
class VideoReader {
 public:
  virtual ~VideoReader() = default;

  /// Of its pictures.
  [[nodiscard]] virtual Size size() const = 0;
  /// Frames a second, as the file says; 0 when it does not.
  [[nodiscard]] virtual double rate() const = 0;

  /// Goes to the next frame. Its time as the file says, from the file's start; none at the end, or
  /// where the file cannot be read any further.
  virtual std::optional<Time> grab() = 0;
  /// The picture of the frame last grabbed, Rgb24. Throws std::runtime_error.
  virtual Frame retrieve() = 0;
  /// Goes back to before the first frame. Throws std::runtime_error.
  virtual void rewind() = 0;
};

/// The library's one function, "eyebridge_open_video". The caller owns what it returns. Throws
/// std::runtime_error with the reason, without the file's name.
using OpenVideo = VideoReader* (*)(const char* path);

}  // namespace eyebridge::camera
