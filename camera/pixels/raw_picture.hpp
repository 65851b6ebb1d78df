#pragma once

#include <cstdint>
#include <span>

#include "eyebridge/camera/frame.hpp"

namespace eyebridge::camera {

/// What cameras send, as far as it is read here.
enum class RawFormat {
  Yuyv,   ///< Y0 U Y1 V for two pixels; BT.601, Y of 16 ... 235.
  Nv12,   ///< All Y, then U and V in turn for four pixels each; as Yuyv.
  Rgb24,  ///< R, G, B.
  Grey,   ///< One byte a pixel, 0 ... 255.
  Mjpeg,  ///< A JPEG a frame, with or without its Huffman tables.
};

/// A picture as it came; its bytes are lent.
struct RawPicture {
  RawFormat format = RawFormat::Yuyv;
  Size size;       ///< Each side at least 1 pixel.
  int stride = 0;  ///< Bytes from a row (of Y) to the next; 0: no padding. No matter for Mjpeg.
  std::span<const std::uint8_t> bytes;
};

}  // namespace eyebridge::camera
