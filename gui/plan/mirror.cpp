#include "plan/mirror.hpp"

#include <algorithm>

namespace eyebridge::gui {
namespace {

/// `model` with devices that do not err.
robot::RobotModel perfect(robot::RobotModel model) {
  for (auto& sensor : model.range_sensors) sensor.error = {};
  for (auto& sensor : model.proximity_sensors) sensor.error = {};
  for (auto& bumper : model.bumpers) bumper.error = {};
  if (model.lidar) model.lidar->error = {};
  return model;
}

/// What looks like `body`, and stands.
world::ObjectSpec like(const world::BodyView& body) {
  world::ObjectSpec object;
  object.kind = body.shape == world::BodyShape::Ball ? world::ObjectKind::Ball
                : body.corners                       ? world::ObjectKind::Polygon
                                                     : world::ObjectKind::Can;
  object.radius = body.radius;
  object.height = body.height;
  if (body.corners) object.corners = *body.corners;
  object.colour = body.colour;
  return object;
}

SensorRay ray(const Pose& sensor, double length, double range) {
  const Vec2 end = sensor.position() + length * Heading::from_angle(sensor.theta).forward();
  return {sensor.position(), end, range};
}

}  // namespace

void Mirror::begin(const hal::WorldLook& look) {
  world_.emplace(look.scene.model, robot::SimulationSettings{});
}

void Mirror::follow(const hal::WorldLook& look) {
  if (!world_ || &world_->world().model() != look.scene.model.get()) begin(look);
  add_newcomers(look);
  world::World& world = world_->world();
  std::vector<bool> is_seen(world.body_count());
  for (const world::BodyView& body : look.scene.bodies) {
    is_seen.at(body.id) = true;
    if (body.shape != world::BodyShape::Robot) world.set_pose(body.id, body.pose);
  }
  for (const world::BodyId body : look.objects) {
    if (!is_seen.at(body)) world.remove(body);
  }
  for (std::size_t i = 0; i < look.robots.size(); ++i) {
    const auto robot = static_cast<robot::RobotIndex>(i);
    if (look.robots[i].is_there) {
      world_->set_pose(robot, look.robots[i].pose);
      if (look.robots[i].depth) world_->set_altitude(robot, look.robots[i].altitude);
    } else if (world_->is_there(robot)) {
      world_->remove_robot(robot);
    }
  }
}

void Mirror::add_newcomers(const hal::WorldLook& look) {
  world::World& world = world_->world();
  while (true) {
    // Where nobody stands: a person may have put bodies into each other.
    constexpr double kFarAway = 1e4;
    constexpr double kApart = 30.0;  // the largest things reach 14.2 m from their places
    const auto next = static_cast<world::BodyId>(world.body_count());
    const Pose place{-kFarAway - kApart * static_cast<double>(next), -kFarAway, 0.0};
    if (std::ranges::find(look.objects, next) != look.objects.end()) {
      const auto seen = std::ranges::find(look.scene.bodies, next, &world::BodyView::id);
      world::ObjectSpec object;  // of one that came and went meanwhile no more than its id
      if (seen != look.scene.bodies.end()) object = like(*seen);
      object.pose = place;
      world.add_object(object);
    } else if (world_->robot_count() < look.robots.size()) {
      world_->add_robot(perfect(*look.robots[world_->robot_count()].model), place);
    } else {
      return;
    }
  }
}

std::vector<SensorRay> Mirror::distance_rays(std::size_t robot) {
  const auto index = static_cast<robot::RobotIndex>(robot);
  const Pose pose = world_->pose(index);
  const auto& sensors = world_->model(index).range_sensors;
  ranges_.resize(sensors.size());
  world_->read_ranges(index, ranges_);  // without error here: as true_range(), at once
  std::vector<SensorRay> rays;
  rays.reserve(sensors.size());
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    const double range = ranges_[i];
    const bool is_seen_from_above = sensors[i].kind != robot::RangeKind::Down;
    rays.push_back(ray(transform(pose, sensors[i].pose_in_robot),
                       is_seen_from_above ? std::min(range, sensors[i].max_range) : 0.0, range));
  }
  return rays;
}

const std::vector<SensorRay>& Mirror::lidar_rays(std::size_t robot) {
  const auto index = static_cast<robot::RobotIndex>(robot);
  const auto& model = world_->model(index);
  scan_.clear();
  if (!model.lidar) return scan_;
  const robot::LidarModel& lidar = *model.lidar;
  ranges_.resize(static_cast<std::size_t>(lidar.points));
  world_->read_lidar(index, lidar.field_of_view, ranges_);
  const Pose sensor = transform(world_->pose(index), lidar.pose_in_robot);
  // As read_lidar() says: a full circle does not repeat its first ray.
  const bool is_circle = lidar.field_of_view >= 2 * kPi - 1e-9;
  const double gap = lidar.field_of_view / std::max(1, is_circle ? lidar.points : lidar.points - 1);
  const Vec2 from = sensor.position();
  // From ray to ray by one turn: no sine for each of thousands.
  const double first = lidar.points == 1 ? 0.0 : lidar.field_of_view / 2;
  Heading heading = Heading::from_angle(sensor.theta + first);
  const Heading turn = Heading::from_angle(-gap);
  for (const double range : ranges_) {
    scan_.push_back({from, from + range * heading.forward(), range});
    heading = heading.turned(turn);
  }
  return scan_;
}

std::vector<SensorRay> Mirror::proximity_rays(std::size_t robot) const {
  const auto index = static_cast<robot::RobotIndex>(robot);
  const Pose pose = world_->pose(index);
  std::vector<SensorRay> rays;
  for (const auto& sensor : world_->model(index).proximity_sensors) {
    const Pose place = transform(pose, sensor.pose_in_robot);
    const double range =
        world_->world().cast_ray(place.position(), Heading::from_angle(place.theta).forward(),
                                 sensor.threshold, world_->body(index));
    rays.push_back(ray(place, range, range));
  }
  return rays;
}

std::vector<bool> Mirror::bumpers(std::size_t robot) {
  const auto index = static_cast<robot::RobotIndex>(robot);
  std::vector<bool> touched(world_->model(index).bumpers.size());
  for (std::size_t i = 0; i < touched.size(); ++i) touched[i] = world_->read_bumper(index, i);
  return touched;
}

bool Mirror::is_free(world::BodyId body, Vec2 place) const {
  const world::WorldModel& model = world_->world().model();
  if (!model.has_floor_at(place)) return false;
  const world::World& world = world_->world();
  if (!world.object_of(body)) return world.is_free(place, world.radius(body), body);
  world::ObjectSpec object = world.object(body);
  object.pose.x = place.x;
  object.pose.y = place.y;
  return world.is_free(object, body);
}

}  // namespace eyebridge::gui
