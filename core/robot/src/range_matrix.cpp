// Sensors with a matrix of ranges: the nearest thing in the cone of each zone.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "eyebridge/base/math.hpp"
#include "simulation_impl.hpp"

namespace eyebridge::robot {
namespace {

constexpr double kNothing = std::numeric_limits<double>::infinity();
constexpr std::size_t kZones = kMatrixSize * kMatrixSize;
// The cones are looked through along lines of rays. A line lies on each edge of a row of zones:
// walls and the floor are nearest at one of the two edges of a row. The rays of a line are a degree
// apart, as those of an ultrasound sensor's cone; some of them lie on the edges of the zones.
constexpr std::size_t kRaysPerZone = 6;
constexpr std::size_t kRays = kMatrixSize * kRaysPerZone + 1;
constexpr std::size_t kLines = kMatrixSize + 1;

/// How far to the side a ray goes for each metre along the axis: the `i`-th of `count` rays that
/// are evenly spread over `field_of_view`, from minus to plus.
double slope(double field_of_view, std::size_t i, std::size_t count) {
  const double share = static_cast<double>(i) / static_cast<double>(count - 1) - 0.5;
  const SinCos angle = sin_cos(field_of_view * share);
  return angle.sin / angle.cos;
}

}  // namespace

void Simulation::read_range_matrix(RobotIndex robot, std::size_t matrix, std::span<double> ranges) {
  RobotDevices& devices = impl_->devices_of(robot);
  const RangeMatrixModel& model = devices.model.range_matrices.at(matrix);
  if (ranges.size() != kZones) throw std::out_of_range("read_range_matrix: one range a zone");
  const world::World& world = impl_->world;
  const world::BodyId self = body(robot);
  const Sight sight =
      Sight(model.pose_in_robot).in_world(world.position(self), world.heading(self));
  const SinCos tilt = sin_cos(model.tilt);
  const double widest = slope(model.field_of_view, kRays - 1, kRays);

  // Of each ray of a line: how far along the axis it meets a wall or a body.
  std::array<double, kRays> walls{};
  const auto look_at_walls = [&](double forward) {
    std::array<Vec2, kRays> directions{};
    std::array<double, kRays> lengths{};  // of the ray on the floor, for a metre along the axis
    std::array<double, kRays> level{};    // ranges on the floor
    for (std::size_t i = 0; i < kRays; ++i) {
      const Vec2 way{forward, -slope(model.field_of_view, i, kRays)};
      lengths[i] = norm(way);
      directions[i] = sight.heading.rotate(way * (1.0 / lengths[i]));
    }
    const double reach = model.max_range * norm(Vec2{forward, widest});
    world.cast_fan(sight.origin, directions, reach, self, level);
    for (std::size_t i = 0; i < kRays; ++i) {
      walls[i] = level[i] < reach ? level[i] / lengths[i] : kNothing;
    }
  };

  std::ranges::fill(ranges, kNothing);
  for (std::size_t line = 0; line < kLines; ++line) {
    const double down = slope(model.field_of_view, line, kLines);
    // Level and downward parts of a ray that goes one metre along the axis.
    const double forward = tilt.cos - down * tilt.sin;
    const double fall = tilt.sin + down * tilt.cos;
    const double floor = fall > 0.0 ? model.height / fall : kNothing;
    if (line == 0 || model.tilt != 0.0) look_at_walls(forward);  // else as for the line above
    for (std::size_t column = 0; column < kMatrixSize; ++column) {
      const auto first = walls.begin() + static_cast<std::ptrdiff_t>(column * kRaysPerZone);
      const double nearest = std::min(*std::min_element(first, first + kRaysPerZone + 1), floor);
      for (const std::size_t row : {line - 1, line}) {  // above the line, below it
        if (row >= kMatrixSize) continue;
        double& range = ranges[row * kMatrixSize + column];
        range = std::min(range, nearest);
      }
    }
  }

  Random& noise = devices.range_matrices[matrix];
  for (double& range : ranges) {
    if (range >= model.max_range) {
      range = model.out_of_range;
    } else if (!model.error.perfect()) {
      range = std::clamp(with_error(range, model.error, noise), 0.0, model.max_range);
      if (model.error.dropout > 0.0 && noise.chance(model.error.dropout))
        range = model.out_of_range;
    }
  }
}

}  // namespace eyebridge::robot
