#pragma once

#include "eyebridge/base/clock.hpp"
#include "fiducials/pose_fit.hpp"

namespace eyebridge::camera {

/// A Kalman filter for a camera carried by hand: pose and its speed, pushed about by white
/// acceleration (Bar-Shalom, Li and Kirubarajan, Estimation with Applications to Tracking and
/// Navigation, chapter 6). Times are any clock's; they do not go back.
class PoseFilter {
 public:
  /// Starts at `fit` of `time`, at rest as far as is known.
  PoseFilter(const PoseFit& fit, Time time);

  /// Carries the estimate on to `time`.
  void predict(Time time);

  /// What a fit at the present time is to start from.
  [[nodiscard]] std::optional<PosePrior> prior() const;

  /// Takes in `fit`, which was made with prior().
  void update(const PoseFit& fit);

  [[nodiscard]] const EyePose& pose() const { return pose_; }
  [[nodiscard]] const Matrix<6, 6>& covariance() const { return pose_covariance_; }
  [[nodiscard]] const Vector<6>& speed() const { return speed_; }
  [[nodiscard]] Time time() const { return time_; }

 private:
  Time time_;
  EyePose pose_;
  Vector<6> speed_{};
  // The covariance of (pose, speed), in blocks.
  Matrix<6, 6> pose_covariance_;
  Matrix<6, 6> cross_covariance_;  ///< Rows: pose; columns: speed.
  Matrix<6, 6> speed_covariance_;
};

}  // namespace eyebridge::camera
