#pragma once

#include <memory>
#include <span>
#include <string>

#include "eyebridge/base/colour.hpp"
#include "eyebridge/base/pose.hpp"
#include "eyebridge/camera/frame.hpp"

namespace eyebridge::camera {

/// A sheet of paper with a map's scale: points and lengths in metres, y up; line widths in pixels.
class Canvas {
 public:
  /// Border round the map, pixels; below it is as much again for the scale bar.
  static constexpr int kBorder = 20;
  static constexpr double kThinLine = 2.0;  ///< Width up to which a line counts as thin, pixels.

  /// Shows the rectangle from `low` to `high`, its longest side with the border `longest_side`
  /// pixels (at least 64). Throws std::bad_alloc.
  Canvas(Vec2 low, Vec2 high, int longest_side, Rgb paper);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// A length of the world in pixels.
  [[nodiscard]] double to_pixels(double metres) const { return scale_ * metres; }

  void fill_rectangle(Vec2 low, Vec2 high, Rgb colour);
  void outline_rectangle(Vec2 low, Vec2 high, Rgb colour);
  /// Thin lines reach half a width beyond `a` and `b`, so that corners close; broader ones are to
  /// scale and end there.
  void line(Vec2 a, Vec2 b, double width, Rgb colour);
  void path(std::span<const Vec2> points, double width, Rgb colour);
  void disc(Vec2 centre, double radius, Rgb colour);
  void ring(Vec2 centre, double radius, Rgb colour);
  void polygon(std::span<const Vec2> corners, Rgb colour);
  /// Centred about `at`; `size` in pixels.
  void text(Vec2 at, const std::string& text, double size, Rgb colour);
  /// A bar `length` metres long with its label, in the border below the map.
  void scale_bar(double length, const std::string& label, Rgb colour);

  /// What has been drawn, Rgb24.
  [[nodiscard]] Frame picture() const;

 private:
  [[nodiscard]] Vec2 at(Vec2 point) const;

  struct Sheet;
  std::unique_ptr<Sheet> sheet_;
  Vec2 low_;
  Vec2 high_;
  double scale_ = 1.0;  ///< Pixels a metre.
};

}  // namespace eyebridge::camera
