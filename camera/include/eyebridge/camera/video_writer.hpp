#pragma once

#include <filesystem>
#include <memory>

#include "eyebridge/camera/frame.hpp"

namespace eyebridge::camera {

/// A video file that is being written; its destructor completes it. One thread at a time.
class VideoWriter {
 public:
  virtual ~VideoWriter() = default;

  /// Appends a picture, Rgb24, of the size that the video was made for; another is a
  /// std::runtime_error.
  virtual void add(const Frame& picture) = 0;
};

/// Begins a video: `.mp4` (MPEG-4) or `.avi` (Motion JPEG), of pictures of `size` pixels, both
/// even, `rate` of them a second. Throws ConfigError for another ending, and for a place that
/// cannot be written to.
std::unique_ptr<VideoWriter> make_video(const std::filesystem::path& file, Size size, double rate);

/// What libeyebridge_video.so exports as "eyebridge_make_video"; `codec` are four letters. The
/// caller owns what it returns. Throws std::runtime_error with the reason, without the file's name.
using MakeVideo = VideoWriter* (*)(const char* path, const char* codec, Size size, double rate);

}  // namespace eyebridge::camera
