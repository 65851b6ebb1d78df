#pragma once

#include <mutex>

#include "eyebridge/camera/frame.hpp"

namespace eyebridge::camera {

/// The frame that was given to somebody last, for others to look at: no pixel is copied, and none
/// is rendered. Any thread.
class LatestFrame {
 public:
  void set(FramePtr frame) {
    const std::lock_guard lock(mutex_);
    frame_.swap(frame);
  }
  /// Null before the first one.
  [[nodiscard]] FramePtr get() const {
    const std::lock_guard lock(mutex_);
    return frame_;
  }

 private:
  mutable std::mutex mutex_;
  FramePtr frame_;
};

}  // namespace eyebridge::camera
