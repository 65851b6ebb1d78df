#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "eyebridge/base/result.hpp"
#include "eyebridge/camera/frame.hpp"
#include "pixels/frame_pool.hpp"

namespace eyebridge::camera {

/// Decodes the frames of an MJPEG stream; keeps what it needs from frame to frame. One thread.
class MjpegDecoder {
 public:
  /// The JPEG `bytes` as Rgb24, in the smallest of turbojpeg's scales (eighths) that is at least
  /// `least` pixels in both directions, at most full size. Fails with Corrupt: cut, damaged, or not
  /// of `size`, the size of the stream. The frame is made by `pool`.
  Result<Frame> decode(std::span<const std::uint8_t> bytes, Size size, Size least, FramePool& pool);

 private:
  Result<Frame> decode_once(std::span<const std::uint8_t> bytes, Size size, Size least,
                            FramePool& pool);

  struct Destroy {
    void operator()(void* decoder) const;
  };
  std::unique_ptr<void, Destroy> decoder_;
};

}  // namespace eyebridge::camera
