#include <algorithm>
#include <array>
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

double Simulation::Impl::ray_range(RobotIndex robot, std::size_t sensor) {
  RobotDevices& its = devices_of(robot);
  const auto alone = [&] {
    return look(robot, its.ranges[sensor].sight, its.model.range_sensors[sensor].max_range);
  };
  if (sensor >= KnownRays::kMost) return alone();
  const KnownRays::Moment now{world.version(), world.heading(eyes[robot].body)};
  const std::uint64_t missing = its.known_rays.ask(now, sensor);
  if (missing == 0) return its.known_rays.range(sensor);
  if ((missing & (missing - 1)) != 0) {
    measure_rays(robot, missing);
  } else {
    its.known_rays.keep(sensor, alone());
  }
  return its.known_rays.range(sensor);
}

void Simulation::Impl::measure_rays(RobotIndex robot, std::uint64_t sensors) {
  const Eyes& its = eyes[robot];
  Looks lent;
  std::array<double, RangeLayout::kMostInFan> ranges;
  std::array<std::size_t, RangeLayout::kMostInFan> which;
  for (const RangeLayout::Fan& fan : its.layout->fans) {
    if (fan.first >= KnownRays::kMost) break;
    std::size_t count = 0;
    const std::size_t end = std::min(fan.first + fan.count, KnownRays::kMost);
    for (std::size_t sensor = fan.first; sensor < end; ++sensor) {
      which[count] = sensor;
      count += (sensors >> sensor) & 1U;
    }
    if (count == 0) continue;
    world::RayFan rays = fan_of(
        its, fan, count, [&](std::size_t ray) { return which[ray]; }, lent);
    rays.ranges = {ranges.data(), count};
    world.cast_fans({&rays, 1});
    for (std::size_t ray = 0; ray < count; ++ray) {
      devices[robot].known_rays.keep(which[ray], ranges[ray]);
    }
  }
}

double Simulation::read_range(RobotIndex robot, std::size_t sensor) {
  RobotDevices& devices = impl_->devices_of(robot);
  RayDevice& device = devices.ranges.at(sensor);
  const RangeSensorModel& model = devices.model.range_sensors[sensor];
  const double range = impl_->measure(robot, sensor);
  const unsigned talkers = model.error.cross_talk > 0.0 ? cross_talkers(robot, sensor) : 0;
  return range_reading(range, model, device.noise, talkers);
}

template <class Which>
world::RayFan Simulation::Impl::fan_of(const Eyes& its, const RangeLayout::Fan& fan,
                                       std::size_t count, Which which, Looks& lent) const {
  const Vec2 position = world.position(its.body);
  const Heading heading = world.heading(its.body);
  for (std::size_t i = 0; i < count; ++i) {
    lent.directions[i] = heading.turned(its.layout->headings[which(i)]).forward();
  }
  world::RayFan rays;
  rays.origin = position + heading.rotate(fan.origin);
  rays.directions = {lent.directions.data(), count};
  rays.max_range = fan.max_range;
  rays.ignore = its.body;
  if (fan.spread == 0.0) return rays;
  for (std::size_t i = 0; i < count; ++i) {
    lent.origins[i] = position + heading.rotate(its.layout->origins[which(i)]);
  }
  rays.origins = {lent.origins.data(), count};
  rays.spread = fan.spread;
  return rays;
}

void Simulation::Impl::add_fans(RobotIndex robot, std::span<double> ranges) {
  const Eyes& its = eyes[robot];
  if (fans.empty()) looks.resize(std::max(world::kFansTogether, its.layout->fans.size()));
  for (const RangeLayout::Fan& fan : its.layout->fans) {
    const auto which = [&](std::size_t ray) { return fan.first + ray; };
    fans.push_back(fan_of(its, fan, fan.count, which, looks[fans.size()]));
    fans.back().ranges = ranges.subspan(fan.first, fan.count);
  }
}

void Simulation::Impl::finish_ranges(RobotIndex robot, std::span<double> ranges) {
  const Eyes& its = eyes[robot];
  const RangeLayout& layout = *its.layout;
  if (its.perfect) {
    const double* const least = layout.min_range.data();
    const double* const most = layout.max_range.data();
    const double* const beyond = layout.out_of_range.data();
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      const double heard = either(ranges[i] >= least[i], ranges[i], beyond[i]);
      ranges[i] = either(ranges[i] < most[i], heard, beyond[i]);
    }
    return;
  }
  RobotDevices& its_devices = devices_of(robot);
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    ranges[i] =
        range_reading(ranges[i], its_devices.model.range_sensors[i], its_devices.ranges[i].noise);
  }
}

void Simulation::read_ranges(RobotIndex robot, std::span<double> ranges) {
  const RangeLayout& layout = *impl_->eyes.at(robot).layout;
  if (ranges.size() != layout.headings.size()) {
    throw std::out_of_range("read_ranges: one range a sensor");
  }
  if (!layout.only_rays) {
    for (std::size_t i = 0; i < ranges.size(); ++i) ranges[i] = read_range(robot, i);
    return;
  }
  impl_->fans.clear();
  impl_->add_fans(robot, ranges);
  impl_->world.cast_fans(impl_->fans);
  impl_->finish_ranges(robot, ranges);
}

void Simulation::read_all_ranges(std::span<double> ranges) {
  std::size_t sensors = 0;
  for (const Eyes& eyes : impl_->eyes) sensors += eyes.layout->headings.size();
  if (ranges.size() != sensors) throw std::out_of_range("read_all_ranges: one range a sensor");
  std::vector<world::RayFan>& fans = impl_->fans;
  fans.clear();
  // Robots whose rays are in `fans`, and where their ranges begin.
  std::size_t first = 0;
  std::size_t at = 0;
  const auto count = [&](std::size_t robot) { return impl_->eyes[robot].layout->headings.size(); };
  const auto cast = [&](std::size_t end) {
    impl_->world.cast_fans(fans);
    fans.clear();
    for (; first < end; at += count(first++)) {
      if (!impl_->eyes[first].layout->only_rays) continue;
      impl_->finish_ranges(static_cast<RobotIndex>(first), ranges.subspan(at, count(first)));
    }
  };
  std::size_t next = 0;
  for (std::size_t i = 0; i < impl_->eyes.size(); next += count(i++)) {
    const auto robot = static_cast<RobotIndex>(i);
    const RangeLayout& layout = *impl_->eyes[i].layout;
    const std::span<double> its = ranges.subspan(next, count(i));
    if (!layout.only_rays) {
      for (std::size_t k = 0; k < its.size(); ++k) its[k] = read_range(robot, k);
      continue;
    }
    if (fans.size() + layout.fans.size() > world::kFansTogether) cast(i);
    impl_->add_fans(robot, its);
  }
  cast(impl_->eyes.size());
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
