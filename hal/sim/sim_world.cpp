#include "sim/sim_world.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace eyebridge::hal {
namespace {

std::string describe(const robot::CollisionEvent& event) {
  return fmt::format("robot {} hit {} at x={:.3f} y={:.3f}", event.robot + 1,
                     event.with_wall ? "a wall" : fmt::format("body {}", event.with_body + 1),
                     event.pose.x, event.pose.y);
}

/// What `sensor` would read without its error. The trace must not draw from the sensors' random
/// streams: a traced run and an untraced one have to be the same.
double true_range(const robot::Simulation& simulation, robot::RobotIndex robot,
                  const robot::RangeSensorModel& sensor) {
  const world::World& world = simulation.world();
  const world::BodyId body = simulation.body(robot);
  const Heading heading = world.heading(body);
  const Vec2 origin = world.position(body) + heading.rotate(sensor.pose_in_robot.position());
  const Vec2 direction = heading.turned(Heading::from_angle(sensor.pose_in_robot.theta)).forward();
  const double range = world.cast_ray(origin, direction, sensor.max_range, body);
  return range < sensor.min_range || range >= sensor.max_range ? sensor.out_of_range : range;
}

}  // namespace

SimWorld::SimWorld(files::Scenario scenario, const robot::SimulationSettings& settings,
                   LogSink& log)
    : directory_(scenario.directory.string()),
      seed_(settings.seed),
      step_length_(from_seconds(settings.step)),
      simulation_(std::make_shared<const world::WorldModel>(std::move(scenario.world)), settings) {
  for (const files::RobotPlacement& placement : scenario.robots) {
    simulation_.add_robot(scenario.models.at(placement.model), placement.pose);
  }
  simulation_.on_collision([&log](const robot::CollisionEvent& event) {
    log.write(Severity::Warning, describe(event));
  });
}

void SimWorld::step() {
  const std::lock_guard lock(mutex_);
  simulation_.step();
  ++steps_;
  if (sink_ != nullptr) trace();
}

void SimWorld::trace_to(TraceSink* sink, robot::RobotIndex robot) {
  const std::lock_guard lock(mutex_);
  sink_ = sink;
  traced_ = robot;
  traced_sensors_.clear();
  for (const auto& sensor : simulation_.model(robot).range_sensors) {
    traced_sensors_.push_back(&sensor);
  }
  std::ranges::sort(traced_sensors_, {}, &robot::RangeSensorModel::id);
  ranges_.resize(traced_sensors_.size());
}

void SimWorld::trace() {
  std::ranges::transform(traced_sensors_, ranges_.begin(), [&](const auto* sensor) {
    return true_range(simulation_, traced_, *sensor);
  });
  sink_->point({static_cast<Time::rep>(steps_) * step_length_, simulation_.pose(traced_),
                simulation_.twist(traced_), simulation_.odometry(traced_), ranges_});
}

const robot::RobotModel& SimWorld::model(robot::RobotIndex robot) const {
  return simulation_.model(robot);
}

}  // namespace eyebridge::hal
