#pragma once

#include "eyebridge/base/pose.hpp"
#include "eyebridge/camera/calibration.hpp"

namespace eyebridge::camera {

// Between the picture that a lens gives and that of a pinhole. Points are on the plane 1 m in front
// of the camera, x right, y down: ((u - cx) / fx, (v - cy) / fy) for the pixel (u, v).

/// Where the lens shows what a pinhole shows at `point` (Brown's model, see Calibration).
Vec2 distorted(const Calibration& lens, Vec2 point);

/// What distorted() maps to `point`, by fixed-point iteration; exact to 1e-9 where the lens can be
/// inverted, which is inside of its pictures.
Vec2 undistorted(const Calibration& lens, Vec2 point);

/// The point of pixel (u, v), and the pixel of a point.
inline Vec2 to_plane(const Calibration& lens, Vec2 pixel) {
  return {(pixel.x - lens.cx) / lens.fx, (pixel.y - lens.cy) / lens.fy};
}
inline Vec2 to_pixel(const Calibration& lens, Vec2 point) {
  return {lens.cx + lens.fx * point.x, lens.cy + lens.fy * point.y};
}

}  // namespace eyebridge::camera
