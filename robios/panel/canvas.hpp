#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "eyebridge/base/colour.hpp"
#include "font.hpp"

namespace eyebridge::robios {

/// An image that is drawn into. Origin top-left; what lies outside is cut off, whatever the
/// coordinates: the work of a call is bounded by the visible part. One thread.
class Canvas {
 public:
  /// Black. Both at least 1.
  Canvas(int width, int height);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] const std::vector<Rgb>& pixels() const { return pixels_; }
  [[nodiscard]] bool contains(int x, int y) const;
  /// x, y must be inside.
  [[nodiscard]] Rgb at(int x, int y) const;

  void pixel(int x, int y, Rgb colour);
  /// Bresenham's line, both ends included.
  void line(int x1, int y1, int x2, int y2, Rgb colour);
  /// Rectangle, both corners included, in any order.
  void area(int x1, int y1, int x2, int y2, Rgb colour, bool fill);
  // The same places with every colour turned into its opposite: twice, and nothing has changed.
  void invert_pixel(int x, int y) { invert(x, y); }
  void invert_line(int x1, int y1, int x2, int y2);
  void invert_area(int x1, int y1, int x2, int y2);  ///< Filled.
  /// Circle of `radius` >= 0 pixels around x, y; radius 0 is one pixel.
  void circle(int x, int y, int radius, Rgb colour, bool fill);
  /// One character with its cell's top-left corner at x, y, blended between paper and ink.
  void glyph(int x, int y, const Font& font, std::uint8_t code, Rgb ink, Rgb paper);
  /// Moves the rows above `bottom` up by `rows` and fills the gap.
  void scroll_up(int rows, int bottom, Rgb fill);

  /// Copies a picture of width x height, `Rgb of(const uint8_t*)` reading one pixel of `bytes`
  /// bytes. Only the visible part is read.
  template <class Of>
  void picture(int x, int y, int width, int height, const std::uint8_t* data, int bytes, Of of);

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }
  void span(std::int64_t x1, std::int64_t x2, std::int64_t y, Rgb colour);
  void point(std::int64_t x, std::int64_t y, Rgb colour);
  void invert(std::int64_t x, std::int64_t y);
  /// Calls `plot(x, y)` for each pixel of a line that may be visible.
  template <class Plot>
  void along_line(int x1, int y1, int x2, int y2, Plot&& plot) const;

  int width_;
  int height_;
  std::vector<Rgb> pixels_;
};

template <class Of>
void Canvas::picture(int x, int y, int width, int height, const std::uint8_t* data, int bytes,
                     Of of) {
  const std::int64_t first_x = x < 0 ? -std::int64_t{x} : 0;
  const std::int64_t first_y = y < 0 ? -std::int64_t{y} : 0;
  const std::int64_t end_x = std::min<std::int64_t>(width, std::int64_t{width_} - x);
  const std::int64_t end_y = std::min<std::int64_t>(height, std::int64_t{height_} - y);
  for (std::int64_t v = first_y; v < end_y; ++v) {
    for (std::int64_t u = first_x; u < end_x; ++u) {
      pixels_[index(static_cast<int>(x + u), static_cast<int>(y + v))] =
          of(data + (v * width + u) * bytes);
    }
  }
}

}  // namespace eyebridge::robios
