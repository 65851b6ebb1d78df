#pragma once

#include <cstdint>
#include <span>
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
  ~LoopbackWriter();
  LoopbackWriter(const LoopbackWriter&) = delete;
  LoopbackWriter& operator=(const LoopbackWriter&) = delete;
  /// One frame, by a queued buffer: with ::write() newer loopbacks start at the first frame only.
  void write(const std::vector<std::uint8_t>& frame);

 private:
  UniqueFd device_;
  std::vector<std::span<std::uint8_t>> buffers_;
  std::uint32_t written_ = 0;  ///< Buffers that have been queued once.
};

}  // namespace eyebridge::camera::testing
