#include "fiducials/pose_filter.hpp"

namespace eyebridge::camera {
namespace {

/// Spectral density of the acceleration, m^2/s^3 and rad^2/s^3: a person who walks slowly turns and
/// stops within some tenths of a second, and holds height and tilt rather steady.
constexpr Vector<6> kPush{1.0, 1.0, 0.2, 12.0, 1.0, 1.0};
/// Of the speeds at the start, squared.
constexpr Vector<6> kStartSpeed{0.25, 0.25, 0.01, 2.0, 0.1, 0.1};

}  // namespace

PoseFilter::PoseFilter(const PoseFit& fit, Time time)
    : time_(time),
      pose_(fit.pose),
      pose_covariance_(fit.covariance),
      speed_covariance_(diagonal(kStartSpeed)) {}

void PoseFilter::predict(Time time) {
  const double dt = to_seconds(time - time_);
  time_ = time;
  if (dt <= 0.0) return;
  Vector<6> step = speed_;
  for (double& value : step) value *= dt;
  pose_ = moved(pose_, step);
  const Matrix<6, 6> push = diagonal(kPush);
  pose_covariance_ = pose_covariance_ + dt * (cross_covariance_ + transposed(cross_covariance_)) +
                     dt * dt * speed_covariance_ + dt * dt * dt / 3.0 * push;
  cross_covariance_ = cross_covariance_ + dt * speed_covariance_ + dt * dt / 2.0 * push;
  speed_covariance_ = speed_covariance_ + dt * push;
}

std::optional<PosePrior> PoseFilter::prior() const {
  const auto information = inverse_of(pose_covariance_, kNearlySingular);
  if (!information) return std::nullopt;
  return PosePrior{pose_, *information};
}

void PoseFilter::update(const PoseFit& fit) {
  const auto information = inverse_of(pose_covariance_, kNearlySingular);
  if (!information) return;
  // The speed follows the pose as far as the two were tied to each other (conditioning of a
  // Gaussian: Bishop, Pattern Recognition and Machine Learning, 2.3.1).
  const Matrix<6, 6> tie = transposed(cross_covariance_) * *information;
  const Vector<6> change = tie * difference(fit.pose, pose_);
  for (std::size_t i = 0; i < 6; ++i) speed_[i] += change[i];
  const Matrix<6, 6> less = pose_covariance_ + -1.0 * fit.covariance;
  speed_covariance_ = speed_covariance_ + -1.0 * (tie * less * transposed(tie));
  cross_covariance_ = fit.covariance * transposed(tie);
  pose_covariance_ = fit.covariance;
  pose_ = fit.pose;
}

}  // namespace eyebridge::camera
