#pragma once

#include "eyebridge/localisation/motion_model.hpp"
#include "eyebridge/localisation/pose_estimate.hpp"

namespace eyebridge::localisation {

/// A landmark as a robot sees it.
struct Sighting {
  double range = 0.0;    ///< Metres from the robot's centre, > 0.
  double bearing = 0.0;  ///< Radians from its front, counter-clockwise.
};

/// How sightings err: normally, range and bearing apart; both > 0.
struct SightingNoise {
  double range_sigma = 0.02;
  double bearing_sigma = 0.02;
};

/// What a landmark's sighting came to.
struct Innovation {
  Sighting residual;      ///< Seen minus expected.
  Matrix2 covariance;     ///< Of the residual.
  double nis = 0.0;       ///< Normalised innovation squared: chi-square with 2 degrees.
  bool accepted = false;  ///< Within the gate, and so taken in.
};

/// 99 % of right sightings have a smaller normalised innovation squared.
inline constexpr double kDefaultGate = 9.21034;

/// Extended Kalman filter for a robot that sees landmarks which it can tell apart (markers, posts),
/// by range and bearing.
///
/// EKF localisation with known correspondences, S. Thrun, W. Burgard and D. Fox, "Probabilistic
/// Robotics" (2005), table 7.2. The covariance is updated in Joseph's form, which stays symmetric
/// and positive (Y. Bar-Shalom, X. R. Li and T. Kirubarajan, "Estimation with Applications to
/// Tracking and Navigation" (2001), section 5.2). Same calls, same bits. Not thread-safe.
class LandmarkEkf {
 public:
  /// Throws std::invalid_argument when the covariance is not symmetric, or has a negative variance.
  explicit LandmarkEkf(const PoseEstimate& start);

  /// The robot drove `seconds` at `twist`, or so its wheels say; motion_model.hpp's velocity model.
  void predict(const Twist& twist, double seconds, const VelocityNoise& noise);
  /// The robot moved by `step`, or so its odometry says.
  void predict(const OdometryStep& step, const OdometryNoise& noise);

  /// The robot sees the landmark that stands at `landmark`, in the world. Sightings outside of the
  /// gate change nothing; an infinite `gate` takes all. Throws std::invalid_argument for noise that
  /// is not positive. A landmark nearer than 1 mm to the estimate has no bearing: not accepted.
  Innovation update(Vec2 landmark, const Sighting& seen, const SightingNoise& noise,
                    double gate = kDefaultGate);

  [[nodiscard]] const PoseEstimate& estimate() const { return estimate_; }

 private:
  PoseEstimate estimate_;
};

}  // namespace eyebridge::localisation
