#include "shared_simulation.hpp"

namespace eyebridge::python {

SharedSimulation::SharedSimulation(std::shared_ptr<const files::Scenario> scenario,
                                   const robot::SimulationSettings& settings)
    : scenario_(std::move(scenario)),
      seed_(settings.seed),
      episode_(std::make_unique<episode::Episode>(scenario_, settings)),
      table_(std::make_shared<StateTable>()) {
  table_->poses.resize(3 * robot_count());
  table_->twists.resize(2 * robot_count());
  write_table();
}

void SharedSimulation::advance(long long steps) {
  const std::lock_guard lock(mutex_);
  episode::Episode& episode = opened();
  for (long long i = 0; i < steps; ++i) episode.step();
  write_table();
}

double SharedSimulation::distance(robot::RobotIndex robot) const {
  const std::lock_guard lock(mutex_);
  return opened().tally().distance(robot);
}

std::uint64_t SharedSimulation::collisions(robot::RobotIndex robot) const {
  const std::lock_guard lock(mutex_);
  return opened().tally().collisions(robot);
}

void SharedSimulation::reset(std::optional<std::uint64_t> seed) {
  const std::lock_guard lock(mutex_);
  episode::Episode& episode = opened();
  if (seed) seed_ = *seed;
  ++generation_;
  episode.reset(seed_);
  write_table();
}

void SharedSimulation::close() {
  const std::lock_guard lock(mutex_);
  episode_.reset();
}

std::uint64_t SharedSimulation::generation() const {
  const std::lock_guard lock(mutex_);
  return generation_;
}

episode::Episode& SharedSimulation::opened() const {
  if (!episode_) throw std::runtime_error("this simulation is closed");
  return *episode_;
}

void SharedSimulation::write_table() {
  if (!episode_) return;
  const robot::Simulation& simulation = episode_->simulation();
  double* pose_out = table_->poses.data();
  double* twist_out = table_->twists.data();
  for (robot::RobotIndex i = 0; i < robot_count(); ++i) {
    const Pose pose = simulation.pose(i);
    const Twist twist = simulation.twist(i);
    *pose_out++ = pose.x;
    *pose_out++ = pose.y;
    *pose_out++ = pose.theta;
    *twist_out++ = twist.linear;
    *twist_out++ = twist.angular;
  }
}

}  // namespace eyebridge::python
