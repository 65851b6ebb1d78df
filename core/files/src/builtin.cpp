#include "builtin.hpp"

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

}  // namespace

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
