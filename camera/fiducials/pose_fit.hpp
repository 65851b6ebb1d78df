#pragma once

#include <optional>
#include <span>
#include <vector>

#include "optics/eye_pose.hpp"

namespace eyebridge::camera {

/// Of a value on a diagonal less than this share is left by rounding: no covariance follows.
inline constexpr double kNearlySingular = 1e-14;

/// A fiducial whose place is known and that is seen: its corners in the world, and where an
/// undistorted picture shows them, pixels.
struct Sighting {
  int id = 0;
  std::array<Vec3, 4> corners{};
  std::array<Vec2, 4> pixels{};
};

/// What is known of a pose without looking: its mean and the inverse of its covariance.
struct PosePrior {
  EyePose mean;
  Matrix<6, 6> information;
};

/// A pose that fits what is seen.
struct PoseFit {
  EyePose pose;
  Matrix<6, 6> covariance;
  double cost = 0.0;  ///< Sum of the squared misses in units of their deviation, prior included.
};

/// How exactly a corner is found, pixels, standard deviation; corners of one fiducial err together,
/// so that this is more than each of them does.
inline constexpr double kCornerDeviation = 0.7;

/// The most probable pose for `sightings` in the undistorted pictures of `lens`, from `start` on:
/// Gauss-Newton steps with Huber's weights (Hartley and Zisserman, appendix 6). None when it does
/// not settle, or does not determine the pose.
std::optional<PoseFit> fit_pose(std::span<const Sighting> sightings, const Calibration& lens,
                                const PosePrior& prior, const EyePose& start);

/// Root mean square of the distance between where the corners are and where they should be seen
/// from `pose`, pixels; infinite when they could not be seen.
double miss(const Sighting& sighting, const Calibration& lens, const EyePose& pose);

}  // namespace eyebridge::camera
