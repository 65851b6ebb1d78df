#include "sim/sim_digital.hpp"

#include "arguments/arguments.hpp"

namespace eyebridge::hal {
namespace {

constexpr std::size_t kInputsAtStart = 8;

std::size_t index_of(int line) { return static_cast<std::size_t>(line) - 1; }

}  // namespace

SimDigital::SimDigital(SimWorld& world, robot::RobotIndex robot) : SimDevice(world, robot) {
  for (std::size_t i = kInputsAtStart; i < lines_.size(); ++i) lines_[i].mode = LineMode::Output;
}

bool SimDigital::level(robot::Simulation& simulation, std::size_t index) const {
  const Line& line = lines_[index];
  if (line.mode == LineMode::Output) return line.driven;
  const std::size_t bumpers = simulation.model(robot_).bumpers.size();
  const std::size_t switches = simulation.model(robot_).proximity_sensors.size();
  if (index < bumpers) return simulation.read_bumper(robot_, index);
  if (index < bumpers + switches) return simulation.read_proximity(robot_, index - bumpers);
  return line.mode == LineMode::PullUp;
}

Result<void> SimDigital::setup(int line, LineMode mode) {
  return check_line(line).map(
      [&] { world_.locked([&](auto&) { lines_[index_of(line)].mode = mode; }); });
}

Result<bool> SimDigital::read(int line) {
  return check_line(line).map(
      [&] { return world_.sensed([&](auto& sim) { return level(sim, index_of(line)); }); });
}

Result<std::uint16_t> SimDigital::read_all() {
  return world_.sensed([&](auto& sim) {
    unsigned bits = 0;
    for (std::size_t i = 0; i < lines_.size(); ++i) bits |= level(sim, i) ? 1U << i : 0U;
    return static_cast<std::uint16_t>(bits);
  });
}

Result<void> SimDigital::write(int line, bool high) {
  return check_line(line).map(
      [&] { world_.locked([&](auto&) { lines_[index_of(line)].driven = high; }); });
}

}  // namespace eyebridge::hal
