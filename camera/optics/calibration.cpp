#include "eyebridge/camera/calibration.hpp"

#include <algorithm>
#include <stdexcept>

#include "eyebridge/base/math.hpp"

namespace eyebridge::camera {

Calibration pinhole(Size size, double horizontal_field_of_view) {
  const SinCos half = sin_cos(0.5 * horizontal_field_of_view);
  Calibration lens;
  lens.size = size;
  lens.fx = lens.fy = 0.5 * size.width * half.cos / half.sin;
  lens.cx = 0.5 * (size.width - 1);
  lens.cy = 0.5 * (size.height - 1);
  return lens;
}

Calibration scaled(const Calibration& calibration, Size size) {
  const Size from = calibration.size;
  if (size.width < 1 || size.height < 1 || from.width < 1 || from.height < 1) {
    throw std::invalid_argument("a calibration for an empty picture");
  }
  // The larger factor fills the new picture; what is over on one side is cut off equally.
  const double factor = std::max(static_cast<double>(size.width) / from.width,
                                 static_cast<double>(size.height) / from.height);
  // Pixel (0, 0) is a centre: its corner, half a pixel away, stays where it is.
  const auto moved = [&](double centre, int old_length, int new_length) {
    return (centre + 0.5 - 0.5 * old_length) * factor + 0.5 * new_length - 0.5;
  };
  Calibration out = calibration;
  out.size = size;
  out.fx *= factor;
  out.fy *= factor;
  out.cx = moved(calibration.cx, from.width, size.width);
  out.cy = moved(calibration.cy, from.height, size.height);
  out.error *= factor;
  return out;
}

}  // namespace eyebridge::camera
