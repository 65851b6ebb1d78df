#pragma once

#include <cstdint>
#include <span>

#include "eyebridge/base/result.hpp"
#include "eyebridge/camera/frame.hpp"
#include "pictures/jpeg_decoder.hpp"
#include "pixels/frame_pool.hpp"

namespace eyebridge::camera {

/// The JPEG `bytes` of an MJPEG stream as Rgb24, in the smallest of eighths that is at least
/// `least` pixels in both directions, at most full size. Fails with Corrupt: cut, damaged, or not
/// of `size`, the size of the stream. The frame is made by `pool`.
Result<Frame> decode_mjpeg(std::span<const std::uint8_t> bytes, Size size, Size least,
                           FramePool& pool);

}  // namespace eyebridge::camera
