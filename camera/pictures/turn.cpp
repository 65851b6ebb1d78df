#include "pictures/turn.hpp"

#include <algorithm>

#include "eyebridge/camera/convert.hpp"

namespace eyebridge::camera {
namespace {

/// Whether rows become columns.
bool lies_on_side(int orientation) { return orientation >= 5 && orientation <= 8; }

}  // namespace

Size upright_size(Size size, int orientation) {
  return lies_on_side(orientation) ? Size{size.height, size.width} : size;
}

Frame upright(const Frame& frame, int orientation) {
  if (orientation <= 1 || orientation > 8) return frame;
  const Size size = upright_size({frame.width, frame.height}, orientation);
  Frame out = make_frame(size.width, size.height, frame.format);
  out.time = frame.time;
  out.sequence = frame.sequence;
  out.odd = frame.odd;
  const auto pixel = static_cast<std::size_t>(bytes_per_pixel(frame.format));
  // Which row and column of the picture are its top and its left, as Exif has them.
  const bool from_bottom =
      orientation == 3 || orientation == 4 || orientation == 7 || orientation == 8;
  const bool from_right =
      orientation == 2 || orientation == 3 || orientation == 6 || orientation == 7;
  for (int y = 0; y < size.height; ++y) {
    std::uint8_t* to =
        out.bytes.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(out.stride);
    for (int x = 0; x < size.width; ++x, to += pixel) {
      int row = y;
      int column = x;
      if (lies_on_side(orientation)) {
        column = from_bottom ? size.height - 1 - y : y;
        row = from_right ? size.width - 1 - x : x;
      } else {
        row = from_bottom ? size.height - 1 - y : y;
        column = from_right ? size.width - 1 - x : x;
      }
      const std::uint8_t* const from =
          frame.row(row).data() + static_cast<std::size_t>(column) * pixel;
      std::copy_n(from, pixel, to);
    }
  }
  return out;
}

}  // namespace eyebridge::camera
