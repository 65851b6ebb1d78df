#include "eyebridge/localisation/landmark_ekf.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "eyebridge/robot/arc.hpp"

namespace eyebridge::localisation {
namespace {

constexpr double kTooNear = 1e-3;  // metres

/// Half of the sum with its transpose: what rounding made of a symmetric matrix.
Matrix3 symmetric(const Matrix3& m) { return 0.5 * (m + transposed(m)); }

/// Of the displacement that `local`, in the robot's frame, comes to, by x, y, theta before it.
Matrix3 pose_jacobian(double theta, Vec2 local) {
  const Vec2 moved = Heading::from_angle(theta).rotate(local);
  return {{1, 0, -moved.y, 0, 1, moved.x, 0, 0, 1}};
}

}  // namespace

LandmarkEkf::LandmarkEkf(const PoseEstimate& start) : estimate_(start) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(start.covariance(i, i) >= 0.0) || start.covariance != transposed(start.covariance)) {
      throw std::invalid_argument("EKF: the start's covariance is none");
    }
  }
}

void LandmarkEkf::predict(const Twist& twist, double seconds, const VelocityNoise& noise) {
  Pose& pose = estimate_.pose;
  const double turn = twist.angular * seconds;
  const world::Arc arc = robot::arc_of({twist.linear * seconds, turn});
  const Heading heading = Heading::from_angle(pose.theta);
  const Vec2 moved = heading.rotate(arc.displacement);
  const Matrix3 by_pose = pose_jacobian(pose.theta, arc.displacement);
  // The chord is distance / turn * (sin turn, 1 - cos turn); by distance, its direction.
  const world::Arc unit = robot::arc_of({seconds, turn});
  const Vec2 by_linear = heading.rotate(unit.displacement);
  // By the turn: the end goes along itself, less what the radius shrinks. Smooth through turn 0,
  // where the quotient is replaced by its limit: half the way, to the left.
  Vec2 local{0.0, 0.5 * twist.linear * seconds};
  constexpr double kStraight = 1e-6;
  if (std::abs(turn) > kStraight) {
    const Vec2 forward = (twist.linear * seconds) * arc.turn.forward();
    local = (1.0 / turn) * (forward - arc.displacement);
  }
  const Vec2 by_angular = heading.rotate(seconds * local);
  const Matrix<3, 3> by_noise{
      {by_linear.x, by_angular.x, 0, by_linear.y, by_angular.y, 0, 0, seconds, seconds}};
  const Matrix3 scatter = diagonal<3>(
      {noise.linear_variance(twist), noise.angular_variance(twist), noise.spin_variance(twist)});
  estimate_.covariance = symmetric(by_pose * estimate_.covariance * transposed(by_pose) +
                                   by_noise * scatter * transposed(by_noise));
  pose = {pose.x + moved.x, pose.y + moved.y, wrap_angle(pose.theta + turn)};
}

void LandmarkEkf::predict(const OdometryStep& step, const OdometryNoise& noise) {
  Pose& pose = estimate_.pose;
  const Heading course = Heading::from_angle(pose.theta + step.first_turn);
  const Vec2 moved = step.travel * course.forward();
  const Matrix3 by_pose{{1, 0, -moved.y, 0, 1, moved.x, 0, 0, 1}};
  const Matrix3 by_noise{{-moved.y, course.cos, 0, moved.x, course.sin, 0, 1, 0, 1}};
  const StepVariances variances = variances_of(step, noise);
  const Matrix3 scatter =
      diagonal<3>({variances.first_turn, variances.travel, variances.second_turn});
  estimate_.covariance = symmetric(by_pose * estimate_.covariance * transposed(by_pose) +
                                   by_noise * scatter * transposed(by_noise));
  pose = step.applied_to(pose);
}

Innovation LandmarkEkf::update(Vec2 landmark, const Sighting& seen, const SightingNoise& noise,
                               double gate) {
  if (!(noise.range_sigma > 0.0 && noise.bearing_sigma > 0.0)) {
    throw std::invalid_argument("EKF: expected a sighting's noise to be positive");
  }
  Pose& pose = estimate_.pose;
  const Vec2 away = landmark - pose.position();
  const double square = norm_squared(away);
  const double range = std::sqrt(square);
  Innovation out;
  if (range < kTooNear) {
    out.nis = std::numeric_limits<double>::infinity();
    return out;
  }
  const double bearing = arc_tan2(away.y, away.x) - pose.theta;
  out.residual = {seen.range - range, wrap_angle(seen.bearing - bearing)};
  const Matrix<2, 3> by_pose{
      {-away.x / range, -away.y / range, 0, away.y / square, -away.x / square, -1}};
  const Matrix2 scatter = diagonal<2>(
      {noise.range_sigma * noise.range_sigma, noise.bearing_sigma * noise.bearing_sigma});
  const Matrix3& before = estimate_.covariance;
  out.covariance = by_pose * before * transposed(by_pose) + scatter;
  const auto information = inverse_of(out.covariance);
  if (!information) {
    out.nis = std::numeric_limits<double>::infinity();
    return out;
  }
  const Matrix<2, 1> residual{{out.residual.range, out.residual.bearing}};
  out.nis = (transposed(residual) * *information * residual)(0, 0);
  if (!(out.nis <= gate)) return out;
  out.accepted = true;
  const Matrix<3, 2> gain = before * transposed(by_pose) * *information;
  const Vector3 correction = gain * residual;
  const Matrix3 kept = diagonal<3>({1, 1, 1}) - gain * by_pose;
  estimate_.covariance =
      symmetric(kept * before * transposed(kept) + gain * scatter * transposed(gain));
  pose = {pose.x + correction(0, 0), pose.y + correction(1, 0),
          wrap_angle(pose.theta + correction(2, 0))};
  return out;
}

}  // namespace eyebridge::localisation
