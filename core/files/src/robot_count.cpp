#include <algorithm>
#include <string>

#include "eyebridge/files/load.hpp"
#include "placement.hpp"

namespace eyebridge::files {

void set_robot_count(Scenario& scenario, std::size_t count, const SourceLocation& where) {
  const std::size_t present = scenario.robots.size();
  if (count <= present) {
    scenario.robots.resize(count);
    return;
  }
  if (present == 0) throw ConfigError(where, "found no robot, expected at least one");
  const RobotPlacement like = scenario.robots.back();
  const std::size_t placed = Placer(scenario).place_many(like.model, count - present);
  for (std::size_t i = present; i < scenario.robots.size(); ++i) {
    scenario.robots[i].program = like.program;
    scenario.robots[i].arguments = like.arguments;
  }
  if (present + placed == count) return;
  throw ConfigError(where, "found " + std::to_string(count) +
                               " robots, but this world has room for " +
                               std::to_string(present + placed) +
                               " of them: expected fewer, or a "
                               "bigger world");
}

std::size_t robots_meant(const Scenario& scenario) {
  // A scenario that places robots itself means those; else load_scenario() put one at a start.
  return std::max(scenario.robots.size(), scenario.world.starts.size());
}

}  // namespace eyebridge::files
