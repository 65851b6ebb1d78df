#pragma once

#include "eyebridge/base/pose.hpp"
#include "eyebridge/base/result.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/mapping/beam_model.hpp"
#include "eyebridge/mapping/occupancy_grid.hpp"
#include "eyebridge/robot/robot_model.hpp"

namespace eyebridge::mapping {

/// What an echo says about the cells in an ultrasonic sensor's cone: inside free, most surely on
/// the axis; one cell or more of the arc at its range occupied, nobody knows which; beyond unknown.
///
/// Moravec and Elfes, "High Resolution Maps from Wide Angle Sonar", ICRA 1985: weights of bearings
/// and the sharing out of one echo over its arc. Along the range as BeamModel has it.
struct ConeModel {
  BeamModel beam;                      ///< Along the range.
  double beam_width = deg_to_rad(30);  ///< Whole opening angle, radians, > 0 and <= pi.

  /// How much a cell at `bearing` off the axis counts, 0 … 1: 1 - (bearing / (width / 2))^2.
  [[nodiscard]] double weight(double bearing) const;
  /// Throws std::invalid_argument, which says what cannot be.
  void check() const;

  friend bool operator==(const ConeModel&, const ConeModel&) = default;
};

/// Of an ultrasonic sensor, from its own cone and errors. Surfaces that it sees from the side
/// mirror the sound away: with any orientation as likely as any other, the share of those counts as
/// dropout.
ConeModel cone_model_of(const robot::RangeSensorModel& sensor);

/// Takes one reading of a sensor at `sensor_in_world` into `grid`, each cell once. A reading that
/// says nothing changes nothing. Fails with OutOfRange, and changes nothing, for a pose that is not
/// finite and where the grid would need more cells than it may have. Throws std::invalid_argument
/// for a model that cannot be.
Result<void> insert_cone(OccupancyGrid& grid, const ConeModel& model, const Pose& sensor_in_world,
                         double range);

}  // namespace eyebridge::mapping
