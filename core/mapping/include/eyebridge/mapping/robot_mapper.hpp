#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "eyebridge/base/pose.hpp"
#include "eyebridge/base/result.hpp"
#include "eyebridge/mapping/occupancy_grid.hpp"
#include "eyebridge/robot/robot_model.hpp"

namespace eyebridge::mapping {

/// Takes readings of one robot's sensors into grids, each by its own inverse model: what a robot
/// that builds a map has. Not thread-safe.
class RobotMapper {
 public:
  /// With the inverse models that follow from the sensors and error models of `model`. Throws
  /// std::invalid_argument for one that cannot be.
  explicit RobotMapper(const robot::RobotModel& model);
  ~RobotMapper();
  RobotMapper(RobotMapper&&) noexcept;
  RobotMapper& operator=(RobotMapper&&) noexcept;

  /// A reading of the range sensor with index `sensor`, taken while the robot was at
  /// `robot_in_world`. Throws std::out_of_range when there is no such sensor; fails as
  /// ScanMapper::insert() does.
  Result<void> insert_range(OccupancyGrid& grid, const Pose& robot_in_world, std::size_t sensor,
                            double range);
  /// Readings of all range sensors, in the order of the model; as many as there are, else
  /// std::out_of_range.
  Result<void> insert_ranges(OccupancyGrid& grid, const Pose& robot_in_world,
                             std::span<const double> ranges);
  /// A scan of the LIDAR over `field_of_view` radians, rays as robot::Simulation::read_lidar() has
  /// them. Throws std::out_of_range when the robot has none.
  Result<void> insert_lidar(OccupancyGrid& grid, const Pose& robot_in_world, double field_of_view,
                            std::span<const double> ranges);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace eyebridge::mapping
