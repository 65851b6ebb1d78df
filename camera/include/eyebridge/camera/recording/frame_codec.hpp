#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "eyebridge/camera/frame.hpp"

namespace eyebridge::camera {

/// How the pixels of a recorded frame are kept.
enum class FrameCodec {
  /// Each byte minus that of the pixel at its left (modulo 256), rows without padding, then the
  /// zlib format (RFC 1950): about half of a webcam's bytes, a few percent of a rendered picture's.
  Lossless,
  /// A JPEG file of quality 90, colours at full resolution.
  Mjpeg,
};

/// What the codec is called in recordings and settings: "lossless", "mjpeg".
std::string_view name_of(FrameCodec codec);
/// None when there is no codec of that name.
std::optional<FrameCodec> find_frame_codec(std::string_view name);

/// What a pixel format is called in recordings: "rgb24", "bgra32", "grey8".
std::string_view name_of(PixelFormat format);
std::optional<PixelFormat> find_pixel_format(std::string_view name);

// Any thread.

/// The pixels of `frame`; its time and sequence are not in them. A frame as Mjpeg is read back as
/// Rgb24, or Grey8 where it was that. Throws std::runtime_error with the reason.
std::vector<std::uint8_t> encode_frame(const Frame& frame, FrameCodec codec);

/// The frame of that size and format which `data` holds. Throws std::runtime_error with the reason
/// when it holds something else, or is damaged. Sides of at least 1.
Frame decode_frame(std::span<const std::uint8_t> data, FrameCodec codec, Size size,
                   PixelFormat format);

}  // namespace eyebridge::camera
