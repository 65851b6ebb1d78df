#pragma once

#include "eyebridge/camera/frame.hpp"

namespace eyebridge::camera {

/// Takes the frames that a program was given, to keep them.
class FrameSink {
 public:
  virtual ~FrameSink() = default;
  /// `frame` is lent for the call. Any thread.
  virtual void take(const Frame& frame) noexcept = 0;
};

}  // namespace eyebridge::camera
