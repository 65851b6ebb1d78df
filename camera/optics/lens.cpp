#include "optics/lens.hpp"

#include <algorithm>
#include <cmath>

#include "eyebridge/base/math.hpp"

namespace eyebridge::camera {
namespace {

constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator*(double k, Vec3 v) { return {k * v.x, k * v.y, k * v.z}; }

Plane plane_through(Vec3 point, Vec3 direction, double behind = 0.0) {
  const Vec3 unit = (1.0 / std::sqrt(dot(direction, direction))) * direction;
  return {unit, -dot(unit, point) - behind};
}

}  // namespace

Lens::Lens(const Eye& eye, int width, int height, double far)
    : eye_(eye), far_(std::max(far, 2.0 * kNear)) {
  const SinCos half = sin_cos(0.5 * eye.horizontal_field_of_view);
  half_width_ = half.sin / half.cos;
  half_height_ = half_width_ * height / width;
  const SinCos h = sin_cos(eye.heading);
  const SinCos p = sin_cos(eye.pitch);
  forward_ = {h.cos * p.cos, h.sin * p.cos, p.sin};
  left_ = {-h.sin, h.cos, 0.0};
  up_ = {-h.cos * p.sin, -h.sin * p.sin, p.cos};

  const Vec3 at{eye.x, eye.y, eye.z};
  frustum_ = {plane_through(at, half_width_ * forward_ + -1.0 * left_),
              plane_through(at, half_width_ * forward_ + left_),
              plane_through(at, half_height_ * forward_ + -1.0 * up_),
              plane_through(at, half_height_ * forward_ + up_), plane_through(at, forward_, kNear)};
}

std::array<float, 16> Lens::clip_from_world() const {
  const Vec3 at{eye_.x, eye_.y, eye_.z};
  // Depth kNear … far onto -1 … 1 (OpenGL 3.3 core, appendix of the perspective matrix).
  const double a = (far_ + kNear) / (far_ - kNear);
  const double b = -2.0 * far_ * kNear / (far_ - kNear);
  const Vec3 rows[4] = {(-1.0 / half_width_) * left_, (-1.0 / half_height_) * up_, a * forward_,
                        forward_};
  std::array<float, 16> matrix{};
  for (std::size_t row = 0; row < 4; ++row) {
    matrix[row] = static_cast<float>(rows[row].x);
    matrix[4 + row] = static_cast<float>(rows[row].y);
    matrix[8 + row] = static_cast<float>(rows[row].z);
    matrix[12 + row] = static_cast<float>(-dot(rows[row], at) + (row == 2 ? b : 0.0));
  }
  return matrix;
}

bool Lens::may_see(Vec3 centre, double radius) const {
  return std::all_of(frustum_.begin(), frustum_.end(),
                     [&](const Plane& plane) { return plane.distance(centre) >= -radius; });
}

}  // namespace eyebridge::camera
