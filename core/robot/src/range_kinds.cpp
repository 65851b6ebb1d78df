// Range sensors that are more than a ray: ultrasound, infrared.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "simulation_impl.hpp"

namespace eyebridge::robot {
namespace {

void demand(bool good, const char* what) {
  if (!good) throw std::invalid_argument(what);
}

/// Whether `place` lies in the cone of `beam_width` radians that opens at `sight`.
bool in_cone(const Sight& sight, double beam_width, Vec2 place) {
  const Vec2 way = place - sight.origin;
  const Vec2 axis = sight.heading.forward();
  return std::abs(arc_tan2(cross(axis, way), dot(axis, way))) <= beam_width / 2;
}

}  // namespace

void check_range_sensor(const RangeSensorModel& model) {
  // Written so that NaN fails, too.
  const UltrasoundModel& sound = model.ultrasound;
  demand(sound.beam_width >= 0.0 && sound.beam_width <= kPi,
         "robot: the beam of an ultrasound sensor must be 0 to 180 degrees wide");
  demand(sound.critical_angle >= 0.0 && sound.critical_angle <= kPi / 2,
         "robot: the critical angle of an ultrasound sensor must be 0 to 90 degrees");
  demand(model.infrared.offset >= 0.0 && model.infrared.contact >= 0.0 &&
             model.infrared.contact <= 1.0,
         "robot: an infrared sensor's offset must not be negative, its signal on contact 0 to 1");
}

double folded_range(double range, const RangeSensorModel& model) {
  if (range >= model.min_range) return range;
  const InfraredModel& curve = model.infrared;
  const double rest = range / model.min_range;
  const double signal =
      (curve.contact + (1.0 - curve.contact) * rest) / (model.min_range + curve.offset);
  if (signal <= 0.0) return std::numeric_limits<double>::infinity();
  // At the fold rounding may put it below.
  return std::max(1.0 / signal - curve.offset, model.min_range);
}

double Simulation::Impl::measure(RobotIndex robot, std::size_t sensor) {
  const RobotDevices& own = devices_of(robot);
  const RangeSensorModel& model = own.model.range_sensors[sensor];
  if (model.kind == RangeKind::Ultrasound) return first_echo(robot, sensor);
  if (model.kind == RangeKind::Down) return model.height + at(robot).chassis->altitude();
  const double range = ray_range(robot, sensor);
  return model.kind == RangeKind::Infrared ? folded_range(range, model) : range;
}

double Simulation::Impl::first_echo(RobotIndex robot, std::size_t sensor) {
  const RobotDevices& own = devices_of(robot);
  const RangeSensorModel& model = own.model.range_sensors[sensor];
  const std::vector<Vec2>& cone = eyes[robot].layout->cones[sensor];
  const world::BodyId self = body_of(robot);
  const Sight sight = own.ranges[sensor].sight.in_world(world.position(self), world.heading(self));
  cone_directions.resize(cone.size());
  cone_ranges.resize(cone.size());
  std::transform(cone.begin(), cone.end(), cone_directions.begin(),
                 [&](Vec2 ray) { return sight.heading.rotate(ray); });
  world.cast_fan(sight.origin, cone_directions, model.max_range, self, cone_ranges);
  // A wall straight ahead lies between two rays: the nearer one must count, however smooth it is.
  const double critical = std::max(model.ultrasound.critical_angle, 0.51 * kConeGap);
  const double least_cosine = critical < kPi / 2 ? sin_cos(critical).cos : 0.0;
  // What comes back before the sensor listens is not heard, what is behind it in the cone may be.
  for (double& range : cone_ranges) {
    if (range < model.min_range) range = model.max_range;
  }
  for (;;) {
    const auto nearest = std::min_element(cone_ranges.begin(), cone_ranges.end());
    if (*nearest >= model.max_range) return model.max_range;
    const Vec2 ray = cone_directions[static_cast<std::size_t>(nearest - cone_ranges.begin())];
    const Vec2 place = sight.origin + *nearest * ray;
    if (world.incidence_cosine(place, ray, self) >= least_cosine) return *nearest;
    *nearest = model.max_range;
  }
}

bool Simulation::Impl::see_each_other(RobotIndex robot, std::size_t sensor, RobotIndex other,
                                      std::size_t others_sensor) const {
  const auto sight_of = [&](RobotIndex whose, std::size_t which) {
    const world::BodyId body = body_of(whose);
    return devices[whose].ranges[which].sight.in_world(world.position(body), world.heading(body));
  };
  const RangeSensorModel& model = devices[robot].model.range_sensors[sensor];
  const RangeSensorModel& others_model = devices[other].model.range_sensors[others_sensor];
  const Sight here = sight_of(robot, sensor);
  const Sight there = sight_of(other, others_sensor);
  const Vec2 way = there.origin - here.origin;
  const double distance = norm(way);
  if (distance >= model.max_range || distance == 0.0) return false;
  if (!in_cone(here, model.ultrasound.beam_width, there.origin) ||
      !in_cone(there, others_model.ultrasound.beam_width, here.origin)) {
    return false;
  }
  // Either the sound gets there, or to the other robot's own body, on which the sensor sits.
  const Vec2 direction = (1.0 / distance) * way;
  const double range = world.cast_ray(here.origin, direction, distance, body_of(robot));
  if (range >= distance) return true;
  constexpr double kOnRim = 1e-6;  // metres
  const world::BodyId body = body_of(other);
  const Vec2 met = here.origin + range * direction;
  return norm(met - world.position(body)) <= world.radius(body) + kOnRim;
}

unsigned Simulation::cross_talkers(RobotIndex robot, std::size_t sensor) const {
  const RangeSensorModel& model = impl_->devices_of(robot).model.range_sensors.at(sensor);
  if (model.kind != RangeKind::Ultrasound) return 0;
  unsigned count = 0;
  for (RobotIndex other = 0; other < robot_count(); ++other) {
    if (!is_there(other)) continue;
    const std::vector<RangeSensorModel>& sensors = impl_->devices[other].model.range_sensors;
    for (std::size_t i = 0; i < sensors.size(); ++i) {
      if (sensors[i].kind != RangeKind::Ultrasound) continue;
      if (other != robot) {
        count += impl_->see_each_other(robot, sensor, other, i) ? 1 : 0;
      } else if (i != sensor) {
        const double between =
            std::abs(wrap_angle(sensors[i].pose_in_robot.theta - model.pose_in_robot.theta));
        const double widths = sensors[i].ultrasound.beam_width + model.ultrasound.beam_width;
        count += between < widths / 2 ? 1 : 0;
      }
    }
  }
  return count;
}

}  // namespace eyebridge::robot
