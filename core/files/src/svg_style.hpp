#pragma once

#include <optional>
#include <string_view>

#include "eyebridge/base/colour.hpp"
#include "eyebridge/base/pose.hpp"

namespace eyebridge::files {

/// A matrix of SVG: x' = a x + c y + e, y' = b x + d y + f.
struct SvgTransform {
  double a = 1;
  double b = 0;
  double c = 0;
  double d = 1;
  double e = 0;
  double f = 0;

  [[nodiscard]] Vec2 apply(Vec2 p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
  /// What `inner` does first, then this.
  [[nodiscard]] SvgTransform after(const SvgTransform& inner) const;
  /// How many times longer a line gets, on the whole.
  [[nodiscard]] double scale() const;
};

/// The text of a `transform`. Throws SvgPathError.
SvgTransform read_svg_transform(std::string_view text);

/// What fills or strokes.
struct SvgPaint {
  enum class Kind { None, Colour, Other };  ///< Other: a gradient, or a name that is not known.
  Kind kind = Kind::None;
  Rgb colour{};
};
SvgPaint read_svg_paint(std::string_view text);

/// A length and its unit: "", "mm", "%", ...; nothing: no length.
struct SvgLength {
  double value = 0;
  std::string_view unit;
  /// Millimetres; nothing for px, %, em and plain numbers, which are no lengths in the world.
  [[nodiscard]] std::optional<double> millimetres() const;
  /// In units of the drawing, 96 an inch; nothing for % and em.
  [[nodiscard]] std::optional<double> units() const;
};
std::optional<SvgLength> read_svg_length(std::string_view text);

}  // namespace eyebridge::files
