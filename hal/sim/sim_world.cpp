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
  simulation_.on_collision([this, &log](const robot::CollisionEvent& event) {
    log.write(Severity::Warning, describe(event));
    if (report_) report_->collision(event);
  });
}

void SimWorld::step() {
  const std::lock_guard lock(mutex_);
  simulation_.step();
  ++steps_;
  if (sink_ != nullptr) trace();
  if (report_) report_->step(simulation_);
}

void SimWorld::report_to(RunReport report) {
  const std::lock_guard lock(mutex_);
  report_.emplace(std::move(report));
}

void SimWorld::end_report() noexcept {
  const std::lock_guard lock(mutex_);
  if (report_) report_->end(simulation_);
}

void SimWorld::trace_to(TraceSink* sink, robot::RobotIndex robot) {
  const std::lock_guard lock(mutex_);
  sink_ = sink;
  traced_ = robot;
  traced_sensors_.clear();
  const auto& sensors = simulation_.model(robot).range_sensors;
  for (std::size_t i = 0; i < sensors.size(); ++i) traced_sensors_.push_back(i);
  std::ranges::sort(traced_sensors_, {}, [&](std::size_t i) { return sensors[i].id; });
  ranges_.resize(traced_sensors_.size());
}

void SimWorld::trace() {
  // Without error: drawing from the sensors' random streams would make a traced run another one.
  std::ranges::transform(traced_sensors_, ranges_.begin(), [&](std::size_t sensor) {
    return simulation_.true_range(traced_, sensor);
  });
  sink_->point({static_cast<Time::rep>(steps_) * step_length_, simulation_.pose(traced_),
                simulation_.twist(traced_), simulation_.odometry(traced_), ranges_});
}

const robot::RobotModel& SimWorld::model(robot::RobotIndex robot) const {
  return simulation_.model(robot);
}

}  // namespace eyebridge::hal
