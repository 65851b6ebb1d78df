#include <algorithm>
#include <stdexcept>

#include "simulation_impl.hpp"

namespace eyebridge::robot {
namespace {

constexpr double kBumperReach = 2e-3;  // metres: the play of a bumper plate
constexpr std::size_t kTogether = 16;  // range sensors whose rays are cast at once

}  // namespace

double Simulation::Impl::look(RobotIndex robot, const Sight& device, double reach) const {
  const world::BodyId self = states.at(robot).body;
  const Sight sight = device.in_world(world.position(self), world.heading(self));
  return world.cast_ray(sight.origin, sight.heading.forward(), reach, self);
}

double Simulation::read_range(RobotIndex robot, std::size_t sensor) {
  RobotDevices& devices = impl_->devices_of(robot);
  RayDevice& device = devices.ranges.at(sensor);
  const RangeSensorModel& model = devices.model.range_sensors[sensor];
  return range_reading(impl_->look(robot, device.sight, model.max_range), model, device.noise);
}

void Simulation::read_ranges(RobotIndex robot, std::span<double> ranges) {
  RobotDevices& devices = impl_->devices_of(robot);
  const std::vector<RangeSensorModel>& models = devices.model.range_sensors;
  if (ranges.size() != models.size()) throw std::out_of_range("read_ranges: one range a sensor");
  const world::World& world = impl_->world;
  const world::BodyId self = body(robot);
  const Vec2 position = world.position(self);
  const Heading heading = world.heading(self);
  // Neighbours that look from one place, equally far, look together.
  for (std::size_t first = 0; first < models.size();) {
    const Sight sight = devices.ranges[first].sight.in_world(position, heading);
    Vec2 directions[kTogether];
    std::size_t count = 0;
    std::size_t i = first;
    for (; i < models.size() && count < kTogether &&
           devices.ranges[i].sight.origin == devices.ranges[first].sight.origin &&
           models[i].max_range == models[first].max_range;
         ++i) {
      directions[count++] = heading.turned(devices.ranges[i].sight.heading).forward();
    }
    const std::span<double> found = ranges.subspan(first, count);
    world.cast_fan(sight.origin, {directions, count}, models[first].max_range, self, found);
    for (std::size_t k = first; k < i; ++k) {
      ranges[k] = models[k].error.perfect()
                      ? range_reading(ranges[k], models[k])
                      : range_reading(ranges[k], models[k], devices.ranges[k].noise);
    }
    first = i;
  }
}

double Simulation::true_range(RobotIndex robot, std::size_t sensor) const {
  const RobotDevices& devices = impl_->devices_of(robot);
  const RayDevice& device = devices.ranges.at(sensor);
  const RangeSensorModel& model = devices.model.range_sensors[sensor];
  return range_reading(impl_->look(robot, device.sight, model.max_range), model);
}

bool Simulation::read_proximity(RobotIndex robot, std::size_t sensor) {
  RobotDevices& devices = impl_->devices_of(robot);
  RayDevice& device = devices.proximities.at(sensor);
  const ProximityModel& model = devices.model.proximity_sensors[sensor];
  const bool near = impl_->look(robot, device.sight, model.threshold) < model.threshold;
  const bool flipped = model.flip_probability > 0.0 && device.noise.chance(model.flip_probability);
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
  return model.miss_probability <= 0.0 || !noise.chance(model.miss_probability);
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
  const std::vector<Vec2>& bearings = devices.scan.directions(field_of_view, ranges.size());
  devices.scan_directions.resize(bearings.size());
  std::transform(bearings.begin(), bearings.end(), devices.scan_directions.begin(),
                 [&](Vec2 bearing) { return sight.heading.rotate(bearing); });
  const SlantedBeam beam(model, tilt);
  world.cast_sweep(sight.origin, devices.scan_directions, devices.scan.gap(), beam.level_reach(),
                   self, ranges);
  for (double& range : ranges) {
    range = beam.range(range);
    if (model.error.perfect() || range >= model.max_range) continue;
    range = std::clamp(with_error(range, model.error, devices.lidar), 0.0, model.max_range);
  }
}

double Simulation::read_compass(RobotIndex robot) {
  RobotDevices& devices = impl_->devices_of(robot);
  const double heading = impl_->world.heading(body(robot)).angle();
  const GaussianError& error = devices.model.compass_error;
  if (error.perfect()) return heading;
  return wrap_angle(with_error(heading, error, devices.compass));
}

}  // namespace eyebridge::robot
