#pragma once

#include <array>
#include <optional>

#include "eyebridge/base/matrix.hpp"
#include "eyebridge/camera/calibration.hpp"
#include "eyebridge/camera/fiducials.hpp"
#include "optics/lens.hpp"

namespace eyebridge::camera {

/// Where a camera is and how it looks, all six of its freedoms: x, y, z, heading, pitch, roll in
/// world metres and radians, as FoundPose has them. Not for cameras that look straight up or down.
struct EyePose {
  Vector<6> values{};

  [[nodiscard]] Vec3 position() const { return {values[0], values[1], values[2]}; }
};

/// Names of the values of an EyePose.
enum : std::size_t { kX, kY, kZ, kHeading, kPitch, kRoll };

/// a - b, the heading's difference within half a turn.
Vector<6> difference(const EyePose& a, const EyePose& b);

/// `pose` moved by `step`, angles brought into (-pi, pi].
EyePose moved(const EyePose& pose, const Vector<6>& step);

/// The pose of a camera whose picture's right and whose axis point along the unit vectors `right`
/// and `forward`.
EyePose eye_pose(Vec3 position, Vec3 right, Vec3 forward);

/// A pixel, and how it moves with each value of the pose it is seen from.
struct Projection {
  Vec2 pixel;
  Matrix<2, 6> jacobian;
};

/// Where a pinhole camera at `pose` sees `point`; none when it lies behind or nearer than 1 mm. The
/// distortion of `lens` is not looked at.
std::optional<Projection> project(const EyePose& pose, const Calibration& lens, Vec3 point);

/// The corners of its black square in the world: top left, top right, bottom right, bottom left, as
/// one sees them who faces the wall.
std::array<Vec3, 4> corners_of(const Fiducial& fiducial);

}  // namespace eyebridge::camera
