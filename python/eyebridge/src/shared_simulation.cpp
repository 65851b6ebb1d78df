#include "shared_simulation.hpp"

namespace eyebridge::python {

SharedSimulation::SharedSimulation(std::shared_ptr<const files::Scenario> scenario,
                                   const robot::SimulationSettings& settings)
    : scenario_(std::move(scenario)),
      model_(std::make_shared<const world::WorldModel>(scenario_->world)),
      settings_(settings),
      table_(std::make_shared<StateTable>()) {
  table_->poses.resize(3 * robot_count());
  table_->twists.resize(2 * robot_count());
  begin();
}

void SharedSimulation::begin() {
  simulation_.emplace(model_, settings_);
  for (const files::RobotPlacement& placed : scenario_->robots) {
    simulation_->add_robot(scenario_->models.at(placed.model), placed.pose);
  }
  write_table();
}

void SharedSimulation::reset(std::optional<std::uint64_t> seed) {
  const std::lock_guard lock(mutex_);
  (void)opened();  // throws once closed
  if (seed) settings_.seed = *seed;
  ++generation_;
  begin();
}

void SharedSimulation::close() {
  const std::lock_guard lock(mutex_);
  simulation_.reset();
}

std::uint64_t SharedSimulation::generation() const {
  const std::lock_guard lock(mutex_);
  return generation_;
}

robot::Simulation& SharedSimulation::opened() const {
  if (!simulation_) throw std::runtime_error("this simulation is closed");
  return *simulation_;
}

void SharedSimulation::write_table() {
  if (!simulation_) return;
  double* pose_out = table_->poses.data();
  double* twist_out = table_->twists.data();
  for (robot::RobotIndex i = 0; i < robot_count(); ++i) {
    const Pose pose = simulation_->pose(i);
    const Twist twist = simulation_->twist(i);
    *pose_out++ = pose.x;
    *pose_out++ = pose.y;
    *pose_out++ = pose.theta;
    *twist_out++ = twist.linear;
    *twist_out++ = twist.angular;
  }
}

}  // namespace eyebridge::python
