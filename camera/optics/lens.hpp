#pragma once

#include <array>

#include "eyebridge/camera/view.hpp"

namespace eyebridge::camera {

/// A point or direction in space, metres; z up.
struct Vec3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

constexpr double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// A half-space: what is in view has dot(normal, point) + offset >= 0. The normal is a unit vector.
struct Plane {
  Vec3 normal;
  double offset = 0.0;

  [[nodiscard]] constexpr double distance(Vec3 point) const { return dot(normal, point) + offset; }
};

/// An Eye with a picture size: the pinhole projection (Hartley and Zisserman, chapter 6) with
/// square pixels and the principal point in the middle.
class Lens {
 public:
  /// Nothing nearer than this is drawn, metres.
  static constexpr double kNear = 0.004;

  /// A picture of `width` x `height` pixels whose farthest point of interest lies `far` metres
  /// away.
  Lens(const Eye& eye, int width, int height, double far);

  /// World to clip coordinates, column-major for OpenGL. Row 0 of the framebuffer is the picture's
  /// top row, so that pictures need no flipping.
  [[nodiscard]] std::array<float, 16> clip_from_world() const;
  /// The planes left, right, top, bottom and near.
  [[nodiscard]] const std::array<Plane, 5>& frustum() const { return frustum_; }
  /// True when a ball round `centre` may be seen.
  [[nodiscard]] bool may_see(Vec3 centre, double radius) const;

  [[nodiscard]] const Eye& eye() const { return eye_; }
  /// Half the picture's width and height on a plane 1 m in front of the pinhole, metres.
  [[nodiscard]] double half_width() const { return half_width_; }
  [[nodiscard]] double half_height() const { return half_height_; }
  [[nodiscard]] Vec3 forward() const { return forward_; }
  [[nodiscard]] Vec3 left() const { return left_; }
  [[nodiscard]] Vec3 up() const { return up_; }

 private:
  Eye eye_;
  double half_width_;
  double half_height_;
  double far_;
  Vec3 forward_;
  Vec3 left_;
  Vec3 up_;
  std::array<Plane, 5> frustum_;
};

}  // namespace eyebridge::camera
