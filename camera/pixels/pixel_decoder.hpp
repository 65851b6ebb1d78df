#pragma once

#include <utility>
#include <vector>

#include "eyebridge/base/result.hpp"
#include "eyebridge/camera/frame.hpp"
#include "pixels/frame_pool.hpp"
#include "pixels/mjpeg_decoder.hpp"
#include "pixels/raw_picture.hpp"

namespace eyebridge::camera {

/// Makes Rgb24 frames of what a camera sends. Keeps its buffers from frame to frame. One thread.
class PixelDecoder {
 public:
  /// `picture` as Rgb24 of `size` pixels (each side at least 1), cut and scaled as fit() does it;
  /// values of YUYV and grey at half the size may be 1 above fit()'s.
  /// An MJPEG that is to be smaller is decoded smaller first, to at least the pixels needed. Time
  /// and sequence are left 0. Fails with Corrupt when the bytes are too few or damaged.
  Result<Frame> decode(const RawPicture& picture, Size size);
  /// `frame`, as decode() gave it, to be shared; its memory is used again afterwards.
  [[nodiscard]] FramePtr share(Frame&& frame) { return pool_.share(std::move(frame)); }

 private:
  void to_rgb(const RawPicture& picture, std::size_t stride, Frame& frame);
  /// The same of YUYV and grey; `frame` has the picture's size, or half of it in both directions.
  void strips_to_rgb(const RawPicture& picture, std::size_t stride, Frame& frame);

  FramePool pool_;
  std::vector<std::uint8_t> strip_;  ///< A few rows of BGRA, small enough for the cache.
  std::vector<std::uint8_t> half_strip_;
};

/// Bytes that a picture without MJPEG of `size` and `stride` needs at least.
std::size_t raw_bytes(RawFormat format, Size size, std::size_t stride);

}  // namespace eyebridge::camera
