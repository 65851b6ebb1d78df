#include "eyebridge/localisation/pose_estimate.hpp"

namespace eyebridge::localisation {

std::optional<double> normalised_error_squared(const PoseEstimate& estimate, const Pose& truth) {
  const auto information = inverse_of(estimate.covariance);
  if (!information) return std::nullopt;
  const Vector3 error{{truth.x - estimate.pose.x, truth.y - estimate.pose.y,
                       wrap_angle(truth.theta - estimate.pose.theta)}};
  return (transposed(error) * *information * error)(0, 0);
}

}  // namespace eyebridge::localisation
