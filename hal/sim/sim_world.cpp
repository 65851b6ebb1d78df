#include "sim/sim_world.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "eyebridge/base/units.hpp"

namespace eyebridge::hal {
namespace {

/// By the numbers that programs use.
std::string name_of(std::optional<robot::RobotIndex> robot, std::optional<std::size_t> object) {
  if (robot) return fmt::format("robot {}", *robot + 1);
  return object ? fmt::format("object {}", *object + 1) : "wall";
}

}  // namespace

Result<robot::RobotIndex> robot_there(const robot::Simulation& simulation, std::size_t index) {
  if (index >= simulation.robot_count()) {
    return fail(Errc::OutOfRange,
                fmt::format("no robot {}, the world has {}", index + 1, simulation.robot_count()));
  }
  const auto robot = static_cast<robot::RobotIndex>(index);
  if (simulation.is_there(robot)) return robot;
  return fail(Errc::OutOfRange, fmt::format("robot {} has been removed", index + 1));
}

SimWorld::SimWorld(files::Scenario scenario, const robot::SimulationSettings& settings,
                   LogSink& log)
    : log_(log),
      directory_(scenario.directory.string()),
      starts_paused_(scenario.start_paused),
      step_length_(from_seconds(settings.step)),
      simulation_(std::make_shared<const world::WorldModel>(std::move(scenario.world)), settings) {
  for (const files::RobotPlacement& placement : scenario.robots) {
    simulation_.add_robot(scenario.models.at(placement.model), placement.pose);
  }
  simulation_.on_collision([this](const robot::CollisionEvent& event) { tell(event); });
}

void SimWorld::tell(const robot::CollisionEvent& event) {
  if (!event.robot && !event.with_robot) return;  // things among themselves
  const std::string who = name_of(event.robot, event.object);
  const std::string with = name_of(event.with_robot, event.with_object);
  // To push a ball, or be met by one, is what a program wants; to run into what stands is not.
  const world::World& world = simulation_.world();
  const bool pushed =
      world.gives_way(event.body) || (!event.with_wall() && world.gives_way(event.with_body));
  log_.write(pushed ? Severity::Info : Severity::Warning,
             fmt::format("{} hit {} at x={:.3f} y={:.3f}", who, event.with_wall() ? "a wall" : with,
                         event.pose.x, event.pose.y));
  if (report_) report_->collision(event);
  // The steps are counted when one is over.
  const Time time = static_cast<Time::rep>(steps_ + 1) * step_length_;
  for (const auto& [robot, traced] : traced_) {
    if (event.robot == robot) traced.sink->contact({time, who, with, event.place});
    if (event.with_robot == robot) traced.sink->contact({time, with, who, event.place});
  }
}

Result<robot::RobotIndex> SimWorld::add_robot(const robot::RobotModel& model, const Pose& pose) {
  const std::lock_guard lock(mutex_);
  try {
    return simulation_.add_robot(model, pose);
  } catch (const std::invalid_argument& error) {
    if (model.drive.facts().dives && model.height > simulation_.world().model().water_depth()) {
      return fail(Errc::OutOfRange, error.what());
    }
    return fail(Errc::OutOfRange,
                fmt::format("{} ({:g} mm across) at ({:g}, {:g}) mm would stand in {}: expected a "
                            "free place",
                            model.name, m_to_mm(model.diameter), m_to_mm(pose.x), m_to_mm(pose.y),
                            obstacle_at(pose.position(), model.radius())));
  }
}

void SimWorld::set_altitude(robot::RobotIndex robot, double altitude) {
  const std::lock_guard lock(mutex_);
  const double reached = simulation_.set_altitude(robot, altitude);
  const std::optional<double> depth = simulation_.depth(robot);
  constexpr double kRounding = 1e-9;  // metres
  if (std::abs(reached - altitude) < kRounding || !depth || has_told_of_water_) return;
  has_told_of_water_ = true;
  log_.write(
      Severity::Warning,
      fmt::format("robot {} at z = {:g} mm is out of the water: expected 0 to {:g} mm; it "
                  "is put to {:g} mm",
                  robot + 1, m_to_mm(altitude), m_to_mm(reached + *depth), m_to_mm(reached)));
}

Result<void> SimWorld::remove_robot(std::size_t index) {
  const std::lock_guard lock(mutex_);
  return robot_there(simulation_, index).map([&](robot::RobotIndex robot) {
    traced_.erase(robot);
    simulation_.remove_robot(robot);
  });
}

Result<void> SimWorld::check_there(std::size_t index) {
  const std::lock_guard lock(mutex_);
  return robot_there(simulation_, index).map([](robot::RobotIndex) {});
}

std::string SimWorld::obstacle_at(Vec2 centre, double radius) const {
  const world::World& world = simulation_.world();
  for (world::BodyId body = 0; body < world.body_count(); ++body) {
    if (!world.is_there(body)) continue;
    if (world.rim_distance(body, centre) >= radius) continue;
    const auto object = world.object_of(body);
    if (object) return name_of(std::nullopt, object);
    for (robot::RobotIndex robot = 0; robot < simulation_.robot_count(); ++robot) {
      if (simulation_.body(robot) == body) return name_of(robot, std::nullopt);
    }
  }
  return "a wall";
}

Time SimWorld::now() {
  const std::lock_guard lock(mutex_);
  return static_cast<Time::rep>(steps_) * step_length_;
}

void SimWorld::step() {
  const std::lock_guard lock(mutex_);
  simulation_.step();
  ++steps_;
  if (steps_ % RunTrace::kStepsALook == 0) run_trace_.add(simulation_.world());
  if (!traced_.empty()) trace();
  if (report_) report_->step(simulation_, run_trace_.value());
}

void SimWorld::report_to(RunReport report) {
  const std::lock_guard lock(mutex_);
  report_.emplace(std::move(report));
}

void SimWorld::note(const std::string& name, double value) {
  const std::lock_guard lock(mutex_);
  if (report_) report_->note(name, value);
}

void SimWorld::end_report() noexcept {
  const std::lock_guard lock(mutex_);
  if (report_) report_->end(simulation_, run_trace_.value());
}

std::string SimWorld::lost_report() {
  const std::lock_guard lock(mutex_);
  return report_ ? report_->lost() : "";
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
  const Time now = static_cast<Time::rep>(steps_) * step_length_;
  for (auto& [robot, traced] : traced_) {
    if (!traced.sink->is_due(now)) {
      traced.sink->point({now, simulation_.pose(robot), {}, {}, {}});
      continue;
    }
    // Without error: drawing from the sensors' random streams would make a traced run another one.
    std::ranges::transform(
        traced.sensors, traced.ranges.begin(),
        [&, robot = robot](std::size_t sensor) { return simulation_.true_range(robot, sensor); });
    traced.sink->point({now, simulation_.pose(robot), simulation_.twist(robot),
                        simulation_.odometry(robot), traced.ranges});
  }
}

robot::RobotModel SimWorld::model(robot::RobotIndex robot) {
  const std::lock_guard lock(mutex_);
  return simulation_.model(robot);
}

}  // namespace eyebridge::hal
