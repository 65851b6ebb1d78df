#pragma once

#include <cstdint>
#include <vector>

#include "eyebridge/robot/robot_model.hpp"

namespace eyebridge::robot {

// P(reading | truth): how likely what a sensor says is, given what there is. The forward models of
// the simulated sensors, exactly: what Simulation::read_... draws is distributed as is said here.
// (S. Thrun, W. Burgard, D. Fox, "Probabilistic Robotics", MIT Press 2005, chapter 6, has such
// mixtures.) For maps and localisation; real devices are as these as far as their error models are.
//
// Readings have a density and, some of them, a probability of their own (a mass): "out of range",
// the entries of a table, the ends of the range where noise is cut off. Integral of the density and
// sum of the masses are 1. Same bits on every CPU; any thread; numbers are finite, but distances
// may be infinite: nothing there.

/// A normally distributed reading; without a deviation, the same one always.
class NormalReadings {
 public:
  /// `sigma` >= 0.
  NormalReadings(double mean, double sigma) : mean_(mean), sigma_(sigma) {}
  /// Of a gyroscope on a robot that turns at `rate`, radians per second, `elapsed` seconds after it
  /// came into its world: for that long its bias has strayed.
  NormalReadings(const GyroscopeError& error, double rate, double elapsed);
  /// Of one axis of an accelerometer, metres per second squared.
  NormalReadings(const AccelerometerError& error, double acceleration);

  /// One over the unit of the reading.
  [[nodiscard]] double density(double reading) const;
  /// Probability of just this reading.
  [[nodiscard]] double mass(double reading) const;
  /// Probability of this reading or less.
  [[nodiscard]] double at_most(double reading) const;
  /// Probability of a reading that is known to `resolution` > 0: of all that are more than half of
  /// that less, and at most half of that more.
  [[nodiscard]] double probability(double reading, double resolution) const;

 private:
  double mean_;
  double sigma_;
};

/// Readings of a compass, radians, -pi … pi; methods as NormalReadings', on the circle.
class HeadingReadings {
 public:
  /// Of a robot that looks along `heading`, radians, any number of turns.
  HeadingReadings(const CompassError& error, double heading);

  [[nodiscard]] double density(double reading) const;
  [[nodiscard]] double mass(double reading) const;
  /// Of the arc of `resolution` radians, at most a turn, about `reading`.
  [[nodiscard]] double probability(double reading, double resolution) const;

 private:
  double mean_;
  double sigma_;
};

/// Readings of a distance sensor, metres; methods as NormalReadings'.
class RangeReadings {
 public:
  /// Of what is `distance` metres away: along the ray, or, for ultrasound, the nearest in the cone
  /// that sends its sound back (how likely it does is a question of the surface, which is not asked
  /// here). Infrared reads what is nearer than its curve's fold as something farther.
  /// `cross_talkers` others are in earshot, Simulation::cross_talkers().
  RangeReadings(const RangeSensorModel& model, double distance, unsigned cross_talkers = 0);
  /// Of a ray of a lidar; `distance` along that ray. Nothing met, and what is lost, reads the full
  /// range.
  RangeReadings(const LidarModel& model, double distance);

  [[nodiscard]] double density(double reading) const;
  [[nodiscard]] double mass(double reading) const;
  [[nodiscard]] double at_most(double reading) const;
  [[nodiscard]] double probability(double reading, double resolution) const;

 private:
  [[nodiscard]] double echo_by(double range) const;
  [[nodiscard]] double unheard_by(double range) const;
  [[nodiscard]] double before_rounding(double range) const;
  [[nodiscard]] double in_range(double reading) const;
  [[nodiscard]] double rounded_to(double reading) const;

  bool met_;      ///< Something is in reach; then readings of it are
  double mean_;   ///< normally distributed, and
  double sigma_;  ///< cut off at 0 and
  double max_range_;
  double listens_from_ = 0.0;  ///< Foreign pulses count from here on.
  double cross_talk_ = 0.0;
  unsigned cross_talkers_ = 0;
  RangeTable table_;  ///< Empty: not rounded.
  double dropout_;
  double out_of_range_;
};

/// What the encoder of a wheel has counted, ticks: every tick is missed by itself, so those that
/// are counted are binomially distributed. Whole numbers: there are masses and no density.
class TickReadings {
 public:
  /// Most ticks that a reading may be of.
  static constexpr double kMostTicks = 1e9;

  /// Of a wheel that has turned one way by `angle`, radians, since its encoder began to count,
  /// which it did at a whole tick: as a robot starts, or a reset there. Turned back, the encoder
  /// counts down. Throws std::invalid_argument unless `ticks_per_revolution` > 0 and the angle is
  /// at most kMostTicks.
  TickReadings(const DriveError& error, double ticks_per_revolution, double angle);

  [[nodiscard]] double mass(std::int64_t ticks) const;
  [[nodiscard]] double at_most(std::int64_t ticks) const;
  /// Of all readings more than half of `resolution` > 0 less than `ticks`, and at most half of that
  /// more; with 1 and a whole number, of this one.
  [[nodiscard]] double probability(double ticks, double resolution = 1.0) const;

 private:
  [[nodiscard]] double missed_at_most(std::int64_t count) const;

  bool counts_down_;
  std::int64_t passed_;        ///< Ticks that went by, however many were counted.
  std::int64_t least_missed_;  ///< What sums_ begins with: fewer are as good as impossible.
  std::vector<double> sums_;   ///< Probability of so many missed ones, or fewer.
};

/// Of a switch that says `seen` while something is (`there`) nearer than its threshold, or not.
inline double probability(const ProximityError& error, bool seen, bool there) {
  return seen == there ? 1.0 - error.flip : error.flip;
}

/// Of a bumper that says `pressed` while something touches it (`touched`), or not.
inline double probability(const BumperError& error, bool pressed, bool touched) {
  if (!touched) return pressed ? 0.0 : 1.0;
  return pressed ? 1.0 - error.miss : error.miss;
}

}  // namespace eyebridge::robot
