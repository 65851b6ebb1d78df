#pragma once

#include <cstddef>
#include <vector>

#include "eyebridge/base/pose.hpp"
#include "eyebridge/base/random.hpp"
#include "eyebridge/robot/robot_model.hpp"

namespace eyebridge::localisation {

// How a robot really moves when it means, or believes, to have moved so: S. Thrun, W. Burgard and
// D. Fox, "Probabilistic Robotics" (2005), chapter 5. Normal distributions; the parameters, the
// book's alphas, are variances.

/// Poses that a robot may have, struct-of-arrays, each with its share of the belief.
struct Particles {
  std::vector<double> x;       ///< Metres.
  std::vector<double> y;       ///< Metres.
  std::vector<double> theta;   ///< Radians, (-pi, pi].
  std::vector<double> weight;  ///< >= 0; together 1, if there are any.

  [[nodiscard]] std::size_t size() const { return x.size(); }
  [[nodiscard]] Pose pose(std::size_t i) const { return {x[i], y[i], theta[i]}; }
  void clear();
  void reserve(std::size_t count);
  void add(const Pose& pose, double share);
};

/// A motion as odometry saw it: a turn, a straight way, another turn (section 5.4).
struct OdometryStep {
  double first_turn = 0.0;   ///< Radians, at most pi / 2 to either side.
  double travel = 0.0;       ///< Metres, negative backwards.
  double second_turn = 0.0;  ///< Radians.

  /// From two poses of one odometry. Of less than 0.1 mm the direction says nothing: it is
  /// travel ahead or back.
  static OdometryStep between(const Pose& before, const Pose& after);
  /// Where it leads to from `pose`.
  [[nodiscard]] Pose applied_to(const Pose& pose) const;
};

/// What one step of odometry may be wrong by; all >= 0.
struct OdometryNoise {
  double turn_by_turn = 0.01;       ///< alpha 1: variance of a turn, by its square.
  double turn_by_travel = 0.1;      ///< alpha 2: variance of each turn by travel^2, rad^2 / m^2.
  double travel_by_travel = 0.01;   ///< alpha 3: variance of the travel, by its square.
  double travel_by_turn = 0.0001;   ///< alpha 4: variance of the travel by turns^2, m^2 / rad^2.
  double least_travel_sigma = 0.0;  ///< Added to all, metres: what a step of no length shows.
  double least_turn_sigma = 0.0;    ///< Likewise of each turn, radians.
};

/// Variances of the three parts of one step: radians squared and metres squared.
struct StepVariances {
  double first_turn = 0.0;
  double travel = 0.0;
  double second_turn = 0.0;
};
StepVariances variances_of(const OdometryStep& step, const OdometryNoise& noise);

/// The noise of odometry of a robot whose drive errs like `error`, for steps of `travel` metres
/// that the simulation made in steps of `tick` metres, both > 0. Independent errors of n steps grow
/// as the root of n, systematic ones (of unequal wheels) as n; the latter are taken for random.
/// Slip takes a wheel's share of a step away; whole ticks of encoders are off by less than one.
/// Throws std::invalid_argument for lengths that are not positive.
OdometryNoise odometry_noise(const robot::DriveError& error, const robot::DriveModel& drive,
                             double travel, double tick);

/// A pose after `step` from `pose`, drawn from the model: sample_motion_model_odometry of table
/// 5.6. Three draws.
Pose sample_motion(const Pose& pose, const OdometryStep& step, const OdometryNoise& noise,
                   Random& random);

/// The same for every particle; weights stay.
void sample_motion(Particles& particles, const OdometryStep& step, const OdometryNoise& noise,
                   Random& random);

/// What speeds may be wrong by (section 5.3); all >= 0. Variances of speeds that are kept up for a
/// whole step of the filter.
struct VelocityNoise {
  double linear_by_linear = 0.01;     ///< alpha 1.
  double linear_by_angular = 0.0001;  ///< alpha 2, m^2 / rad^2.
  double angular_by_linear = 0.1;     ///< alpha 3, rad^2 / m^2.
  double angular_by_angular = 0.01;   ///< alpha 4.
  double spin_by_linear = 0.0;        ///< alpha 5: of a turn on the spot at the end, rad^2 / m^2.
  double spin_by_angular = 0.0;       ///< alpha 6.

  /// Variances of the linear and angular speed of `twist`, and of the turn at the end.
  [[nodiscard]] double linear_variance(const Twist& twist) const;
  [[nodiscard]] double angular_variance(const Twist& twist) const;
  [[nodiscard]] double spin_variance(const Twist& twist) const;
};

/// The noise of odometry_noise() for commanded or measured speeds, kept up over `travel` metres.
VelocityNoise velocity_noise(const robot::DriveError& error, const robot::DriveModel& drive,
                             double travel, double tick);

/// A pose `seconds` after `pose` at speed `twist`, drawn from the model:
/// sample_motion_model_velocity of table 5.3. Three draws.
Pose sample_motion(const Pose& pose, const Twist& twist, double seconds, const VelocityNoise& noise,
                   Random& random);

}  // namespace eyebridge::localisation
