#pragma once

#include <string>
#include <utility>

#include "v4l2/video_calls.hpp"

namespace eyebridge::camera {

/// The one owner of an open video device. Moved, never copied.
class VideoHandle {
 public:
  /// Opens `path`; look at error() before anything else.
  VideoHandle(VideoCalls& calls, std::string path, bool converting = false)
      : calls_(&calls), path_(std::move(path)), device_(calls.open(path_, converting)) {}
  VideoHandle(VideoHandle&& other) noexcept
      : calls_(other.calls_), path_(std::move(other.path_)), device_(other.release()) {}
  VideoHandle& operator=(VideoHandle&&) = delete;
  VideoHandle(const VideoHandle&) = delete;
  VideoHandle& operator=(const VideoHandle&) = delete;
  ~VideoHandle() { close(); }

  /// Closes it now; does nothing when it is closed.
  void close() {
    const int device = release();
    if (device >= 0) calls_->close(device);
  }

  /// The errno with which opening failed; 0 when it did not.
  [[nodiscard]] int error() const { return device_ < 0 ? -device_ : 0; }
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] VideoCalls& calls() const { return *calls_; }
  [[nodiscard]] int device() const { return device_; }

  /// 0 or -errno.
  template <class Argument>
  int control(unsigned long request, Argument& argument) const {
    return calls_->control(device_, request, &argument);
  }

 private:
  int release() { return std::exchange(device_, -1); }

  VideoCalls* calls_;
  std::string path_;
  int device_;
};

}  // namespace eyebridge::camera
