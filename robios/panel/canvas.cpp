#include "canvas.hpp"

#include <cmath>
#include <cstdlib>
#include <utility>

namespace eyebridge::robios {
namespace {

/// Square root of n <= 2^62, rounded to the nearest integer; exact, whatever the FPU.
std::int64_t rounded_root(std::int64_t n) {
  auto root = static_cast<std::int64_t>(std::sqrt(static_cast<double>(n)));
  while (root * root > n) {
    --root;
  }
  while ((root + 1) * (root + 1) <= n) {
    ++root;
  }
  return n - root * root > root ? root + 1 : root;
}

std::uint8_t blend(std::uint8_t paper, std::uint8_t ink, unsigned coverage) {
  return static_cast<std::uint8_t>((paper * (255 - coverage) + ink * coverage + 127) / 255);
}

}  // namespace

Canvas::Canvas(int width, int height)
    : width_(width),
      height_(height),
      pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

bool Canvas::contains(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }

Rgb Canvas::at(int x, int y) const { return pixels_[index(x, y)]; }

void Canvas::point(std::int64_t x, std::int64_t y, Rgb colour) {
  if (x >= 0 && y >= 0 && x < width_ && y < height_) {
    pixels_[index(static_cast<int>(x), static_cast<int>(y))] = colour;
  }
}

void Canvas::span(std::int64_t x1, std::int64_t x2, std::int64_t y, Rgb colour) {
  if (y < 0 || y >= height_) {
    return;
  }
  const std::int64_t first = std::max<std::int64_t>(x1, 0);
  const std::int64_t last = std::min<std::int64_t>(x2, width_ - 1);
  for (std::int64_t x = first; x <= last; ++x) {
    pixels_[index(static_cast<int>(x), static_cast<int>(y))] = colour;
  }
}

void Canvas::pixel(int x, int y, Rgb colour) { point(x, y, colour); }

template <class Plot>
void Canvas::along_line(int x1, int y1, int x2, int y2, Plot&& plot) const {
  // Steps along the longer axis ("major"), from the end with the smaller coordinate, and only over
  // the part that is visible on it. Offsets are computed anew at each step instead of summed up, so
  // that skipping ahead changes no pixel. |d| < 2^32, so that the products below fit 64 bits.
  const bool steep = std::abs(std::int64_t{y2} - y1) > std::abs(std::int64_t{x2} - x1);
  std::int64_t major1 = steep ? y1 : x1;
  std::int64_t minor1 = steep ? x1 : y1;
  std::int64_t major2 = steep ? y2 : x2;
  std::int64_t minor2 = steep ? x2 : y2;
  if (major1 > major2) {
    std::swap(major1, major2);
    std::swap(minor1, minor2);
  }
  const auto length = static_cast<std::uint64_t>(major2 - major1);
  const auto rise = static_cast<std::uint64_t>(std::abs(minor2 - minor1));
  const std::int64_t first = std::max<std::int64_t>(major1, 0);
  const std::int64_t last = std::min<std::int64_t>(major2, (steep ? height_ : width_) - 1);
  for (std::int64_t major = first; major <= last; ++major) {
    const auto along = static_cast<std::uint64_t>(major - major1);
    const auto offset =
        length == 0 ? 0 : static_cast<std::int64_t>((rise * along + length / 2) / length);
    const std::int64_t minor = minor2 < minor1 ? minor1 - offset : minor1 + offset;
    steep ? plot(minor, major) : plot(major, minor);
  }
}

void Canvas::line(int x1, int y1, int x2, int y2, Rgb colour) {
  along_line(x1, y1, x2, y2, [&](std::int64_t x, std::int64_t y) { point(x, y, colour); });
}

void Canvas::invert(std::int64_t x, std::int64_t y) {
  if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
  Rgb& pixel = pixels_[index(static_cast<int>(x), static_cast<int>(y))];
  const auto opposite = [](std::uint8_t channel) {
    return static_cast<std::uint8_t>(255 - channel);
  };
  pixel = {opposite(pixel.r), opposite(pixel.g), opposite(pixel.b)};
}

void Canvas::invert_line(int x1, int y1, int x2, int y2) {
  along_line(x1, y1, x2, y2, [&](std::int64_t x, std::int64_t y) { invert(x, y); });
}

void Canvas::invert_area(int x1, int y1, int x2, int y2) {
  const int first_x = std::max(std::min(x1, x2), 0);
  const int first_y = std::max(std::min(y1, y2), 0);
  const int last_x = std::min(std::max(x1, x2), width_ - 1);
  const int last_y = std::min(std::max(y1, y2), height_ - 1);
  for (int y = first_y; y <= last_y; ++y) {
    for (int x = first_x; x <= last_x; ++x) invert(x, y);
  }
}

void Canvas::area(int x1, int y1, int x2, int y2, Rgb colour, bool fill) {
  const int left = std::min(x1, x2);
  const int right = std::max(x1, x2);
  const int top = std::min(y1, y2);
  const int bottom = std::max(y1, y2);
  const int last = std::min(bottom, height_ - 1);
  for (int y = std::max(top, 0); y <= last; ++y) {
    if (fill || y == top || y == bottom) {
      span(left, right, y, colour);
    } else {
      point(left, y, colour);
      point(right, y, colour);
    }
  }
}

void Canvas::circle(int x, int y, int radius, Rgb colour, bool fill) {
  const std::int64_t square = std::int64_t{radius} * radius;
  // One pixel a row where the rim is steep, one a column where it is flat; the halves meet.
  for (int row = 0; row < height_; ++row) {
    const std::int64_t dy = std::int64_t{row} - y;
    if (std::abs(dy) > radius) {
      continue;
    }
    const std::int64_t half = rounded_root(square - dy * dy);
    if (fill) {
      span(x - half, x + half, row, colour);
    }
    if (half >= std::abs(dy)) {
      point(x - half, row, colour);
      point(x + half, row, colour);
    }
  }
  for (int column = 0; column < width_; ++column) {
    const std::int64_t dx = std::int64_t{column} - x;
    if (std::abs(dx) > radius) {
      continue;
    }
    const std::int64_t half = rounded_root(square - dx * dx);
    if (half >= std::abs(dx)) {
      point(column, y - half, colour);
      point(column, y + half, colour);
    }
  }
}

void Canvas::glyph(int x, int y, const Font& font, std::uint8_t code, Rgb ink, Rgb paper) {
  const auto coverage = font.glyph(code);
  std::size_t i = 0;
  for (int row = 0; row < font.cell_height(); ++row) {
    for (int column = 0; column < font.cell_width(); ++column, ++i) {
      const unsigned c = coverage[i];
      point(std::int64_t{x} + column, std::int64_t{y} + row,
            {blend(paper.r, ink.r, c), blend(paper.g, ink.g, c), blend(paper.b, ink.b, c)});
    }
  }
}

void Canvas::scroll_up(int rows, int bottom, Rgb fill) {
  const int count = std::min(rows, bottom);
  const auto begin = pixels_.begin();
  const auto end = begin + static_cast<std::ptrdiff_t>(index(0, bottom));
  const auto rest = std::move(begin + static_cast<std::ptrdiff_t>(index(0, count)), end, begin);
  std::fill(rest, end, fill);
}

}  // namespace eyebridge::robios
