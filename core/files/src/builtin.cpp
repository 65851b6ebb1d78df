#include "builtin.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "eyebridge/files/load.hpp"
#include "eyebridge/files/readers.hpp"
#include "text.hpp"

namespace eyebridge::files {
namespace {

const std::vector<robot::RobotModel>& builtin_robots() {
  static const std::vector<robot::RobotModel> robots = [] {
    std::vector<robot::RobotModel> out;
    std::vector<Warning> warnings;  // a test reads the same files and expects none
    for (const BuiltinText& builtin : builtin_texts()) {
      out.push_back(read_robi(builtin.text, std::string(builtin.file), warnings));
    }
    return out;
  }();
  return robots;
}

bool has(const robot::RobotModel& robot, std::string_view kind, int id) {
  if (kind == "tof") {
    return std::ranges::any_of(robot.range_matrices,
                               [&](const auto& matrix) { return matrix.id == id; });
  }
  if (kind == "lidar") return robot.lidar.has_value();
  if (id < 1) return false;
  const auto number = static_cast<unsigned>(id);
  if (kind == "PSD") {
    return std::ranges::any_of(robot.range_sensors, [&](const auto& psd) { return psd.id == id; });
  }
  if (kind == "servo") return std::ranges::count(robot.servo_indices(), number - 1) > 0;
  if (kind == "motor") return number <= robot.drive.motor_count();
  if (kind == "encoder") return number <= robot.drive.encoder_count();
  return false;
}

}  // namespace

std::vector<std::string> robots_with(std::string_view kind, int id) {
  std::vector<std::string> names;
  for (const robot::RobotModel& robot : builtin_robots()) {
    if (has(robot, kind, id)) names.push_back(robot.name);
  }
  return names;
}

std::vector<std::string> robots_with_psd(std::string_view name) {
  std::vector<std::string> names;
  for (const robot::RobotModel& robot : builtin_robots()) {
    const bool has_it = std::ranges::any_of(
        robot.range_sensors, [&](const auto& psd) { return lower(psd.name) == lower(name); });
    if (has_it) names.push_back(robot.name);
  }
  return names;
}

std::string_view builtin_names() {
  static const std::string names = [] {
    std::vector<std::string_view> list;
    for (const robot::RobotModel& robot : builtin_robots()) list.push_back(robot.name);
    return one_of(list);
  }();
  return names;
}

const robot::RobotModel* builtin_robot(std::string_view name) {
  const std::string wanted = lower(name);
  for (const robot::RobotModel& robot : builtin_robots()) {
    if (lower(robot.name) == wanted) return &robot;
  }
  return nullptr;
}

}  // namespace eyebridge::files
