#include <algorithm>
#include <bit>
#include <stdexcept>

#include "simulation_impl.hpp"

namespace eyebridge::robot {
namespace {

constexpr double kBumperReach = 2e-3;  // metres: the play of a bumper plate

/// `first` ? a : b, by masks: a branch would be a coin's toss.
double either(bool first, double a, double b) {
  const std::uint64_t mask = 0 - static_cast<std::uint64_t>(first);
  return std::bit_cast<double>((std::bit_cast<std::uint64_t>(a) & mask) |
                               (std::bit_cast<std::uint64_t>(b) & ~mask));
}

}  // namespace

double Simulation::Impl::look(RobotIndex robot, const Sight& device, double reach) const {
  const world::BodyId self = body_of(robot);
  const Sight sight = device.in_world(world.position(self), world.heading(self));
  return world.cast_ray(sight.origin, sight.heading.forward(), reach, self);
}

double Simulation::read_range(RobotIndex robot, std::size_t sensor) {
  RobotDevices& devices = impl_->devices_of(robot);
  RayDevice& device = devices.ranges.at(sensor);
  const RangeSensorModel& model = devices.model.range_sensors[sensor];
  if (model.kind != RangeKind::Ray) {
    const double range = impl_->measure(robot, sensor);
    const unsigned talkers = model.error.cross_talk > 0.0 ? cross_talkers(robot, sensor) : 0;
    return range_reading(range, model, device.noise, talkers);
  }
  return range_reading(impl_->look(robot, device.sight, model.max_range), model, device.noise);
}

void Simulation::read_ranges(RobotIndex robot, std::span<double> ranges) {
  const Eyes& eyes = impl_->eyes.at(robot);
  const RangeLayout& layout = *eyes.layout;
  if (ranges.size() != layout.headings.size()) {
    throw std::out_of_range("read_ranges: one range a sensor");
  }
  if (!layout.only_rays) {
    for (std::size_t i = 0; i < ranges.size(); ++i) ranges[i] = read_range(robot, i);
    return;
  }
  const world::World& world = impl_->world;
  // Who asks all robots asks them in order.
  if (std::size_t{robot} + 1 < impl_->eyes.size() && !layout.fans.empty()) {
    const world::BodyId next = impl_->eyes[robot + 1].body;
    world.expect_fan(world.position(next), layout.fans.front().max_range);
  }
  const world::BodyId self = eyes.body;
  const Vec2 position = world.position(self);
  const Heading heading = world.heading(self);
  for (const RangeLayout::Fan& fan : layout.fans) {
    Vec2* const directions = impl_->directions.data();
    const Heading* const headings = layout.headings.data() + fan.first;
    for (std::size_t i = 0; i < fan.count; ++i) {
      directions[i] = heading.turned(headings[i]).forward();
    }
    world.cast_fan(position + heading.rotate(fan.origin), {directions, fan.count}, fan.max_range,
                   self, ranges.subspan(fan.first, fan.count));
  }
  if (eyes.perfect) {
    const double* const least = layout.min_range.data();
    const double* const most = layout.max_range.data();
    const double* const beyond = layout.out_of_range.data();
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      const double heard = either(ranges[i] >= least[i], ranges[i], beyond[i]);
      ranges[i] = either(ranges[i] < most[i], heard, beyond[i]);
    }
    return;
  }
  RobotDevices& devices = impl_->devices_of(robot);
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    ranges[i] = range_reading(ranges[i], devices.model.range_sensors[i], devices.ranges[i].noise);
  }
}

double Simulation::true_range(RobotIndex robot, std::size_t sensor) const {
  const RangeSensorModel& model = impl_->devices_of(robot).model.range_sensors.at(sensor);
  return range_reading(impl_->measure(robot, sensor), model);
}

bool Simulation::read_proximity(RobotIndex robot, std::size_t sensor) {
  RobotDevices& devices = impl_->devices_of(robot);
  RayDevice& device = devices.proximities.at(sensor);
  const ProximityModel& model = devices.model.proximity_sensors[sensor];
  const bool near = impl_->look(robot, device.sight, model.threshold) < model.threshold;
  const bool flipped = !model.error.perfect() && device.noise.chance(model.error.flip);
  return near != flipped;
}

bool Simulation::read_bumper(RobotIndex robot, std::size_t bumper) {
  RobotDevices& devices = impl_->devices_of(robot);
  Random& noise = devices.bumpers.at(bumper);
  const BumperModel& model = devices.model.bumpers[bumper];
  const world::BodyId self = body(robot);
  const Heading heading = impl_->world.heading(self);
  impl_->contacts.clear();
  impl_->world.contacts(self, kBumperReach, impl_->contacts);
  const bool touched =
      std::any_of(impl_->contacts.begin(), impl_->contacts.end(), [&](Vec2 contact) {
        const double bearing =
            arc_tan2(cross(heading.forward(), contact), dot(heading.forward(), contact));
        return in_sector(bearing, model.start, model.end);
      });
  if (!touched) return false;
  return model.error.perfect() || !noise.chance(model.error.miss);
}

void Simulation::read_lidar(RobotIndex robot, double field_of_view, std::span<double> ranges) {
  read_lidar(robot, field_of_view, model(robot).lidar.value().tilt, ranges);
}

void Simulation::read_lidar(RobotIndex robot, double field_of_view, double tilt,
                            std::span<double> ranges) {
  RobotDevices& devices = impl_->devices_of(robot);
  const LidarModel& model = devices.model.lidar.value();
  const world::World& world = impl_->world;
  const world::BodyId self = body(robot);
  const Sight sight =
      Sight(model.pose_in_robot).in_world(world.position(self), world.heading(self));
  const ScanShape& scan = impl_->scans.of(field_of_view, ranges.size());
  std::vector<Vec2>& directions = impl_->scan_directions;
  directions.resize(scan.directions.size());
  std::transform(scan.directions.begin(), scan.directions.end(), directions.begin(),
                 [&](Vec2 bearing) { return sight.heading.rotate(bearing); });
  const SlantedBeam beam(model, tilt);
  world.cast_sweep(sight.origin, directions, scan.gap, beam.level_reach(), self, ranges);
  if (beam.is_level() && model.error.perfect()) return;
  for (double& range : ranges) {
    range = beam.range(range);
    if (model.error.perfect() || range >= model.max_range) continue;
    range = std::clamp(with_error(range, model.error, devices.lidar), 0.0, model.max_range);
    if (model.error.dropout > 0.0 && devices.lidar.chance(model.error.dropout)) {
      range = model.max_range;
    }
  }
}

double Simulation::read_compass(RobotIndex robot) {
  RobotDevices& devices = impl_->devices_of(robot);
  const double heading = impl_->world.heading(body(robot)).angle();
  const CompassError& error = devices.model.compass_error;
  if (error.perfect()) return heading;
  return wrap_angle(with_error(heading, error, devices.compass));
}

}  // namespace eyebridge::robot
