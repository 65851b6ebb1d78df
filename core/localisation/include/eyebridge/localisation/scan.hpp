#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "eyebridge/base/pose.hpp"
#include "eyebridge/mapping/raster.hpp"
#include "eyebridge/robot/robot_model.hpp"

namespace eyebridge::localisation {

/// What a range sensor saw in one sweep: points in the robot's frame, metres.
struct Scan {
  Vec2 origin;               ///< Where the rays leave.
  std::vector<Vec2> hits;    ///< Where they met something.
  std::vector<Vec2> misses;  ///< As far as the others looked.

  /// At most `count` of the hits, > 0, as evenly spread over their order as can be; no misses.
  [[nodiscard]] Scan thinned(std::size_t count) const;
};

/// The scan that `ranges` of Simulation::read_lidar() with this `field_of_view` (radians) are, for
/// a robot with `lidar`. A range of `max_range` or more, where nothing was met, is a miss; one that
/// is not a positive number is left out. Throws std::invalid_argument for a scanner that is tilted:
/// it sees the floor.
Scan scan_of(std::span<const double> ranges, double field_of_view, const robot::LidarModel& lidar);

/// The scan that `ranges` of Simulation::read_ranges() are, for a robot with these distance sensors
/// (PSDs), each at its own place; the origin is the robot's centre. A reading out of a sensor's
/// reach is a miss; one that is not a positive number is left out. Throws std::invalid_argument
/// unless there are as many ranges as sensors.
Scan scan_of(std::span<const double> ranges, std::span<const robot::RangeSensorModel> sensors);

/// What `scan` saw, in the frame of its robot, as a map to fit the next one into: cells of
/// `resolution` metres, > 0, that hits lie in, and those on the lines between a hit and the next
/// one, if it is at most `gap` metres away. With a margin of `margin` metres.
mapping::Raster<std::uint8_t> walls_seen(const Scan& scan, double resolution, double gap,
                                         double margin);

}  // namespace eyebridge::localisation
