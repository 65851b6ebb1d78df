#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <span>
#include <vector>

#include "eyebridge/base/colour.hpp"
#include "font.hpp"

namespace eyebridge::robios {

/// Black pixels that take no memory before they are drawn: hundreds of robots have a screen each,
/// and most of them show a few lines.
class LazyPixels {
 public:
  explicit LazyPixels(std::size_t count)
      : pixels_(static_cast<Rgb*>(std::calloc(count, sizeof(Rgb)))), size_(count) {
    if (pixels_ == nullptr) throw std::bad_alloc();
  }
  [[nodiscard]] Rgb& operator[](std::size_t i) { return pixels_[i]; }
  [[nodiscard]] const Rgb& operator[](std::size_t i) const { return pixels_[i]; }
  [[nodiscard]] Rgb* data() { return pixels_.get(); }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  struct Free {
    void operator()(Rgb* pixels) const { std::free(pixels); }
  };
  std::unique_ptr<Rgb[], Free> pixels_;
  std::size_t size_;
};

/// An image that is drawn into. Origin top-left; what lies outside is cut off, whatever the
/// coordinates: the work of a call is bounded by the visible part. One thread.
class Canvas {
 public:
  /// Black. Both 1 … 65535.
  Canvas(int width, int height);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  /// A copy, row by row.
  [[nodiscard]] std::vector<Rgb> pixels() const;
  /// One row; y must be inside. Valid until the canvas is changed.
  [[nodiscard]] std::span<const Rgb> row(int y) const {
    return {&pixels_[index(0, y)], static_cast<std::size_t>(width_)};
  }
  [[nodiscard]] bool contains(int x, int y) const;
  /// x, y must be inside.
  [[nodiscard]] Rgb at(int x, int y) const;

  void pixel(int x, int y, Rgb colour);
  /// Bresenham's line, both ends included.
  void line(int x1, int y1, int x2, int y2, Rgb colour);
  /// Rectangle, both corners included, in any order.
  void area(int x1, int y1, int x2, int y2, Rgb colour, bool filled);
  // The same places with every colour turned into its opposite: twice, and nothing has changed.
  void invert_pixel(int x, int y) { invert(x, y); }
  void invert_line(int x1, int y1, int x2, int y2);
  void invert_area(int x1, int y1, int x2, int y2);  ///< Filled.
  /// Circle of `radius` >= 0 pixels around x, y; radius 0 is one pixel.
  void circle(int x, int y, int radius, Rgb colour, bool filled);
  /// One character with its cell's top-left corner at x, y, blended between paper and ink.
  void glyph(int x, int y, const Font& font, std::uint8_t code, Rgb ink, Rgb paper);
  /// Copies a picture of a cell of `font`, row by row; the whole cell must be inside.
  void stamp(int x, int y, const Font& font, const Rgb* picture);
  /// Moves the rows above `bottom` up by `rows` and fills the gap. Rows change places, pixels stay:
  /// programs that print line after line scroll all the time.
  void scroll_up(int rows, int bottom, Rgb colour);

  /// Copies a picture of width x height, `Rgb of(const uint8_t*)` reading one pixel of `bytes`
  /// bytes. Only the visible part is read.
  template <class Of>
  void picture(int x, int y, int width, int height, const std::uint8_t* data, int bytes, Of of);

 private:
  /// A row changes its place when the screen scrolls. Right of what was drawn in it, it has one
  /// colour: an empty row that scrolls in again costs next to nothing.
  struct Row {
    std::uint16_t place = 0;  ///< Among the rows of pixels_.
    std::uint16_t drawn = 0;  ///< Columns from here on show `ground`.
    Rgb ground;
  };

  [[nodiscard]] std::size_t index(int x, int y) const {
    return rows_[static_cast<std::size_t>(y)].place * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }
  void drawn(int y, int end);
  template <int kWidth>
  void stamp_cell(int x, int y, int height, const Rgb* picture);
  void span(std::int64_t x1, std::int64_t x2, std::int64_t y, Rgb colour);
  void point(std::int64_t x, std::int64_t y, Rgb colour);
  void invert(std::int64_t x, std::int64_t y);
  /// Calls `plot(x, y)` for each pixel of a line that may be visible.
  template <class Plot>
  void along_line(int x1, int y1, int x2, int y2, Plot&& plot) const;

  int width_;
  int height_;
  std::vector<Row> rows_;
  LazyPixels pixels_;
};

template <class Of>
void Canvas::picture(int x, int y, int width, int height, const std::uint8_t* data, int bytes,
                     Of of) {
  const std::int64_t first_x = x < 0 ? -std::int64_t{x} : 0;
  const std::int64_t first_y = y < 0 ? -std::int64_t{y} : 0;
  const std::int64_t end_x = std::min<std::int64_t>(width, std::int64_t{width_} - x);
  const std::int64_t end_y = std::min<std::int64_t>(height, std::int64_t{height_} - y);
  for (std::int64_t v = first_y; v < end_y; ++v) {
    drawn(static_cast<int>(y + v), static_cast<int>(x + end_x));
    for (std::int64_t u = first_x; u < end_x; ++u) {
      pixels_[index(static_cast<int>(x + u), static_cast<int>(y + v))] =
          of(data + (v * width + u) * bytes);
    }
  }
}

}  // namespace eyebridge::robios
