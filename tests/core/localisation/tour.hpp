#pragma once

#include <cstdint>
#include <vector>

#include "eyebridge/localisation/scan.hpp"
#include "eyebridge/mapping/raster.hpp"
#include "eyebridge/robot/simulation.hpp"

namespace eyebridge::localisation::testing {

/// A flat of 4 m x 3 m in which no two places look the same.
world::WorldModel flat();

/// What of `model` walls pass through; walls on multiples of `resolution` pass through the middle
/// of cells. With a margin of 10 cells.
mapping::Raster<std::uint8_t> walls_in(const world::WorldModel& model, double resolution);

/// Where a robot of `radius` can stand in `model`, by the cells of `occupied`.
mapping::Raster<std::uint8_t> room_for(const world::WorldModel& model,
                                       const mapping::Raster<std::uint8_t>& occupied,
                                       double radius);

/// An S4 with a LIDAR of 180 rays and the errors of a preset.
robot::RobotModel scanner(const char* preset);

/// What there is to know at one point of a tour.
struct Stop {
  Pose truth;
  Pose odometry;
  Scan scan;
};

/// Of a robot that drives through the whole flat and back to where it began, (0.5, 0.5), turned to
/// the north: a stop every 10 cm or 15 degrees.
std::vector<Stop> tour_of(const robot::RobotModel& model, std::uint64_t seed);

/// Metres, and radians >= 0.
double distance(const Pose& a, const Pose& b);
double turn_between(const Pose& a, const Pose& b);

}  // namespace eyebridge::localisation::testing
