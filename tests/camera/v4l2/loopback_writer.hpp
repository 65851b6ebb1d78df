#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <linux/videodev2.h>

#include "eyebridge/base/unique_fd.hpp"

namespace eyebridge::camera::testing {

/// The sending end of a v4l2loopback device.
class LoopbackWriter {
 public:
  /// Sets the format and starts: only then may readers open it. Throws std::runtime_error.
  LoopbackWriter(const std::string& path, std::uint32_t fourcc, int width, int height,
                 int fps = 30);
  /// One frame.
  void write(const std::vector<std::uint8_t>& frame) const;

 private:
  UniqueFd device_;
};

}  // namespace eyebridge::camera::testing
