#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "eyebridge/base/result.hpp"
#include "eyebridge/camera/frame.hpp"

namespace eyebridge::camera {

struct JpegOptions {
  std::uint64_t most_pixels = 0;  ///< Larger ones are refused.
  std::optional<Size> size = {};  ///< It must be of this size.
  Size least = {};       ///< Decoded to the smallest of the eighths that is as large; {}: in full.
  bool is_fast = false;  ///< Colours by copies, not interpolated.
};

/// The JPEG in `bytes` as Rgb24, by libjpeg-turbo. `make` gives the frame that is filled. CMYK
/// becomes RGB. Fails with Corrupt where rows are missing or wrong: cut, damaged; and for what the
/// options refuse.
Result<Frame> decode_jpeg(std::span<const std::uint8_t> bytes, const JpegOptions& options,
                          const std::function<Frame(int width, int height)>& make);

/// What its header says: the size of the picture, and how it lies (Exif's orientation, 1 ... 8).
struct JpegHeader {
  Size size;
  int orientation = 1;
};
/// Fails with Corrupt.
Result<JpegHeader> read_jpeg_header(std::span<const std::uint8_t> bytes);

}  // namespace eyebridge::camera
