#pragma once

#include <vector>

#include "eyebridge/robot/robot_model.hpp"

namespace eyebridge::mapping {

/// What a reading of one narrow beam says about the cells along it: the inverse sensor model.
///
/// The first surface is at the reading, with the sensor's own Gaussian error: cells that are surely
/// nearer are free, the one that holds the surface is occupied, nothing is known of those behind
/// (Elfes, "Using Occupancy Grids for Mobile Robot Perception and Navigation", Computer 22(6),
/// 1989; Thrun, Burgard and Fox, "Probabilistic Robotics", 2005, section 9.2). A cell's probability
/// is the mean over where the surface may be, so that a wider error moves the belief less.
///
/// Readings are treated as REP 117 of ROS has it: +inf, `out_of_range` and all from `max_range` on
/// mean that nothing was met; NaN, -inf and negative ones say nothing and are passed over.
struct BeamModel {
  double min_range = 0.0;        ///< Nearer surfaces read as out of range, metres.
  double max_range = 9.999;      ///< Metres, > 0.
  double out_of_range = 9.999;   ///< The reading that means it, metres.
  double bias = 0.0;             ///< Of readings, metres: taken off.
  double sigma = 0.0;            ///< Standard deviation, metres, >= 0: sigma + sigma_relative *
  double sigma_relative = 0.0;   ///< range +
  double sigma_quadratic = 0.0;  ///< range squared; 1 / metre, >= 0.
  std::vector<double> levels{};  ///< Readings that there are, ascending, metres; empty: all.
  double dropout = 0.0;          ///< Probability that a surface within reach reads as out of range.
  /// Probability that a reading is of a surface nearer than `min_range` (the ambiguity of
  /// triangulating infrared sensors).
  double fold = 0.0;
  /// Probability of a cell that a beam crossed, at even odds before: less than 1/2, more than 0,
  /// since walls fill parts of cells.
  double crossed = 0.35;
  /// Probability of a cell that a beam surely ended in, at even odds before: more than 1/2.
  double met = 0.85;
  double empty_share = 0.5;  ///< Share of beams that meet nothing within reach; (0, 1).

  /// Standard deviation of a reading of `range` metres, with the rounding to `levels`.
  [[nodiscard]] double sigma_at(double range) const;
  /// Whether a reading says something: a number, or +inf, not negative.
  [[nodiscard]] static bool is_reading(double range) { return range >= 0.0; }
  /// Whether a reading means that nothing was met.
  [[nodiscard]] bool is_out_of_range(double range) const {
    return range >= max_range || range == out_of_range;
  }
  /// Probability of a cell that the beam crosses from `near` to `far` metres, given the reading
  /// `range` alone, at even odds before it: 1/2 for a reading that says nothing. `near` < `far`.
  /// The log-odds of this are what a map adds. A sensor is taken to err by one hundredth of the
  /// cell at least.
  [[nodiscard]] double probability(double range, double near, double far) const;
  /// The same of a cell beyond `min_range` that a beam out of range crossed: the less dropout, the
  /// nearer to `crossed`.
  [[nodiscard]] double probability_out_of_range() const;
  /// Throws std::invalid_argument, which says what cannot be.
  void check() const;

  friend bool operator==(const BeamModel&, const BeamModel&) = default;
};

/// Of a distance sensor, from its own error model and its table.
BeamModel beam_model_of(const robot::RangeSensorModel& sensor);
/// Of a LIDAR's beams over the floor, from its own error model; of a tilted one, readings of
/// level_range(). Floor that a beam ends on is no obstacle.
BeamModel beam_model_of(const robot::LidarModel& lidar);
/// Distance over the floor of what a beam of `lidar` read as `range`, metres.
double level_range(const robot::LidarModel& lidar, double range);

}  // namespace eyebridge::mapping
