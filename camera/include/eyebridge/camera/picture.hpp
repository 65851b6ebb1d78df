#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "eyebridge/camera/frame.hpp"

namespace eyebridge::camera {

/// Pictures of more pixels are not read: no floor needs them, and decoding one would take over a
/// gigabyte.
inline constexpr std::uint64_t kMostPicturePixels = 100'000'000;

/// Reads a PNG, a JPEG, an uncompressed BMP of 8, 24 or 32 bits, a PBM, PGM or PPM, a TIFF or a
/// WebP as Rgb24 (the last two by OpenCV); what it is shows by its first bytes, its name does not
/// matter. Throws std::runtime_error naming the file and the reason:
/// for what cannot be opened, is none of these, is cut, damaged or too large. Any thread.
Frame read_picture(const std::filesystem::path& path);

/// The size that read_picture() would give, without decoding it. Throws likewise for what cannot be
/// opened, is none of these, or has no complete header. Any thread.
Size picture_size(const std::filesystem::path& path);

/// read_picture() for the bytes of such a file; pictures of more than `most_pixels` are refused.
/// Throws std::runtime_error with the reason alone.
Frame decode_picture(std::span<const std::uint8_t> bytes,
                     std::uint64_t most_pixels = kMostPicturePixels);

}  // namespace eyebridge::camera
