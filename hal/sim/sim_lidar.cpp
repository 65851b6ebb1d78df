#include "sim/sim_lidar.hpp"

#include <algorithm>

#include "eyebridge/base/math.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::hal {
namespace {

constexpr const char* kName = "lidar";

/// Ranges measured in the plane, as a beam tilted by `tilt` from `height` above the floor has them.
void tilt_ranges(std::span<double> ranges, double tilt, double height, double max_range) {
  const SinCos angle = sin_cos(tilt);
  const double floor = angle.sin > 0.0 ? height / angle.sin : max_range;
  for (double& range : ranges) {
    const double wall = range < max_range ? range / angle.cos : max_range;
    range = std::min({wall, floor, max_range});
  }
}

}  // namespace

SimLidar::SimLidar(SimWorld& world, robot::RobotIndex robot) : SimDevice(world, robot) {
  const robot::LidarModel& model = *world.model(robot).lidar;
  shape_ = {model.field_of_view, model.tilt, model.points};
}

Result<void> SimLidar::configure(double field_of_view, double tilt, int points) {
  return require(field_of_view > 0.0 && field_of_view <= 2 * kPi, kName, field_of_view,
                 "a field of view of more than 0, at most 2 pi")
      .and_then([&] {
        return require(std::abs(tilt) < kPi / 2, kName, tilt, "a tilt between -pi/2 and pi/2");
      })
      .and_then([&] {
        return require(points >= kFewestPoints && points <= kMostPoints, kName, points,
                       "2 … 36000 points");
      })
      .map([&] { world_.locked([&](auto&) {
                   shape_ = {field_of_view, tilt, points};
                 }); });
}

SimLidar::Shape SimLidar::shape() const {
  return world_.locked([&](auto&) { return shape_; });
}

int SimLidar::points() const { return shape().points; }

Result<void> SimLidar::read(std::span<double> ranges) {
  return world_.locked([&](auto& sim) -> Result<void> {
    if (ranges.size() != static_cast<std::size_t>(shape_.points)) {
      return fail(Errc::OutOfRange, "lidar: got room for " + std::to_string(ranges.size()) +
                                        " ranges, expected " + std::to_string(shape_.points));
    }
    sim.read_lidar(robot_, shape_.field_of_view, ranges);
    const robot::LidarModel& model = *sim.model(robot_).lidar;
    if (shape_.tilt != 0.0) tilt_ranges(ranges, shape_.tilt, model.height, model.max_range);
    return {};
  });
}

double SimLidar::max_range() const { return world_.model(robot_).lidar->max_range; }

}  // namespace eyebridge::hal
