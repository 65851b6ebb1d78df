#pragma once

#include <optional>

#include "eyebridge/base/matrix.hpp"
#include "eyebridge/base/pose.hpp"

namespace eyebridge::localisation {

using Matrix2 = Matrix<2, 2>;
using Matrix3 = Matrix<3, 3>;
using Vector3 = Matrix<3, 1>;

/// Where something is believed to be, and how surely.
struct PoseEstimate {
  Pose pose;           ///< In the world, metres, radians.
  Matrix3 covariance;  ///< Of x, y and theta: m^2, m rad, rad^2.
};

/// Square of Mahalanobis's distance of the true pose from `estimate`, in its own covariance: the
/// normalised estimation error squared (NEES) of Y. Bar-Shalom, X. R. Li and T. Kirubarajan,
/// "Estimation with Applications to Tracking and Navigation" (2001), section 5.4. Nothing when the
/// covariance is not positive definite.
std::optional<double> normalised_error_squared(const PoseEstimate& estimate, const Pose& truth);

}  // namespace eyebridge::localisation
