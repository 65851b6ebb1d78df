#pragma once

#include <cstdint>
#include <span>

#include "eyebridge/camera/frame.hpp"

namespace eyebridge::camera {

// The decoders behind decode_picture(): bytes of a whole file to Rgb24. Each throws
// std::runtime_error with the reason, and refuses more than `most_pixels`.

Frame decode_png(std::span<const std::uint8_t> bytes, std::uint64_t most_pixels);
/// A JPEG that libjpeg-turbo only warns of (cut, odd markers) counts as damaged.
Frame decode_jpeg(std::span<const std::uint8_t> bytes, std::uint64_t most_pixels);
/// Uncompressed, 8 bits with a palette, 24 or 32 bits, either row order, Windows' or OS/2's header.
Frame decode_bmp(std::span<const std::uint8_t> bytes, std::uint64_t most_pixels);
/// PBM, PGM and PPM, text or binary.
Frame decode_pnm(std::span<const std::uint8_t> bytes, std::uint64_t most_pixels);
/// The first picture of a TIFF, by OpenCV: loads libeyebridge_video.so.
Frame decode_tiff(std::span<const std::uint8_t> bytes, std::uint64_t most_pixels);
/// The first picture of a WebP, by OpenCV, too.
Frame decode_webp(std::span<const std::uint8_t> bytes, std::uint64_t most_pixels);

// The sizes of their pictures, from the headers alone. Each throws likewise.

Size png_size(std::span<const std::uint8_t> bytes);
Size jpeg_size(std::span<const std::uint8_t> bytes);
Size bmp_size(std::span<const std::uint8_t> bytes);
Size pnm_size(std::span<const std::uint8_t> bytes);
Size tiff_size(std::span<const std::uint8_t> bytes);
Size webp_size(std::span<const std::uint8_t> bytes);

/// An empty Rgb24 picture for the pixels. Throws when a side is less than 1, or when there are more
/// than `most_pixels`.
Frame frame_to_decode(std::int64_t width, std::int64_t height, std::uint64_t most_pixels);

}  // namespace eyebridge::camera
