#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "eyebridge/base/pose.hpp"

namespace eyebridge::files {

/// A line of an SVG drawing, in its units; straight between its points, without the last one again
/// where it is closed.
struct SvgLine {
  std::vector<Vec2> points;
  bool closed = false;
};

/// What is wrong with path data, and where.
class SvgPathError : public std::runtime_error {
 public:
  SvgPathError(std::size_t offset, const std::string& what)
      : std::runtime_error(what), offset_(offset) {}
  [[nodiscard]] std::size_t offset() const { return offset_; }

 private:
  std::size_t offset_;
};

/// Points that a drawing may have.
inline constexpr std::size_t kMostSvgPoints = 1'000'000;

/// The lines of path data, the `d` of a path (W3C, SVG 1.1, chapter 8): curves and arcs become
/// straight pieces that miss them by at most `tolerance`, in units of the drawing. Throws
/// SvgPathError.
std::vector<SvgLine> read_svg_path(std::string_view data, double tolerance);

/// A whole ellipse as straight pieces that miss it by at most `tolerance`.
SvgLine svg_ellipse(Vec2 centre, double rx, double ry, double tolerance);

/// Reads the numbers of a list with blanks and commas between them. Throws SvgPathError.
std::vector<double> read_svg_numbers(std::string_view text);

}  // namespace eyebridge::files
