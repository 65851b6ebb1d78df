#include "sim/sim_lidar.hpp"

#include <cmath>

#include "arguments/arguments.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::hal {
namespace {

constexpr const char* kName = "lidar";

}  // namespace

SimLidar::SimLidar(SimWorld& world, robot::RobotIndex robot) : SimDevice(world, robot) {
  const robot::RobotModel model = world.model(robot);
  shape_ = {model.lidar->field_of_view, model.lidar->tilt, model.lidar->points};
  max_range_ = model.lidar->max_range;
}

Result<void> SimLidar::configure(double field_of_view, double tilt, int points) {
  return require(field_of_view > 0.0 && field_of_view <= 2 * kPi, kName, field_of_view,
                 "a field of view of more than 0, at most 2 pi")
      .and_then(
          [&] { return require(std::abs(tilt) <= kPi / 2, kName, tilt, "a tilt of -pi/2 … pi/2"); })
      .and_then([&] {
        return require(points >= kFewestPoints && points <= kMostPoints, kName, points,
                       "1 … 36000 points");
      })
      .map([&] { world_.locked([&](auto&) {
                   shape_ = {field_of_view, tilt, points};
                 }); });
}

LidarShape SimLidar::shape() const {
  return world_.locked([&](auto&) { return shape_; });
}

Result<void> SimLidar::read(std::span<double> ranges) {
  return world_.sensed_all(ranges, [&](auto& sim) {
    return check_scan_size(ranges.size(), shape_.points).map([&] {
      sim.read_lidar(robot_, shape_.field_of_view, shape_.tilt, ranges);
    });
  });
}

}  // namespace eyebridge::hal
