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

}  // namespace

SimWorld::SimWorld(files::Scenario scenario, const robot::SimulationSettings& settings,
                   LogSink& log)
    : directory_(scenario.directory.string()),
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
  if (!traced_.empty()) trace();
}

void SimWorld::trace_to(TraceSink* sink, robot::RobotIndex robot) {
  const std::lock_guard lock(mutex_);
  traced_.erase(robot);
  if (sink == nullptr) return;
  Traced& traced = traced_[robot];
  traced.sink = sink;
  const auto& sensors = simulation_.model(robot).range_sensors;
  for (std::size_t i = 0; i < sensors.size(); ++i) traced.sensors.push_back(i);
  std::ranges::sort(traced.sensors, {}, [&](std::size_t i) { return sensors[i].id; });
  traced.ranges.resize(traced.sensors.size());
}

void SimWorld::trace() {
  for (auto& [robot, traced] : traced_) {
    // Without error: drawing from the sensors' random streams would make a traced run another one.
    std::ranges::transform(
        traced.sensors, traced.ranges.begin(),
        [&, robot = robot](std::size_t sensor) { return simulation_.true_range(robot, sensor); });
    traced.sink->point({static_cast<Time::rep>(steps_) * step_length_, simulation_.pose(robot),
                        simulation_.twist(robot), simulation_.odometry(robot), traced.ranges});
  }
}

const robot::RobotModel& SimWorld::model(robot::RobotIndex robot) const {
  return simulation_.model(robot);
}

}  // namespace eyebridge::hal
