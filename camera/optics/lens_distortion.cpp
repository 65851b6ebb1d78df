#include "optics/lens_distortion.hpp"

#include <algorithm>

namespace eyebridge::camera {

Vec2 distorted(const Calibration& lens, Vec2 point) {
  const auto& [k1, k2, p1, p2, k3] = lens.distortion;
  const double r2 = norm_squared(point);
  const double radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
  const double xy = point.x * point.y;
  return {point.x * radial + 2.0 * p1 * xy + p2 * (r2 + 2.0 * point.x * point.x),
          point.y * radial + p1 * (r2 + 2.0 * point.y * point.y) + 2.0 * p2 * xy};
}

Vec2 undistorted(const Calibration& lens, Vec2 point) {
  Vec2 guess = point;
  for (int i = 0; i < 50; ++i) {
    const Vec2 miss = point - distorted(lens, guess);
    guess = guess + miss;
    if (norm_squared(miss) < 1e-22) break;
  }
  return guess;
}

}  // namespace eyebridge::camera
