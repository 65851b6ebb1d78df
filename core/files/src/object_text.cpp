#include "eyebridge/files/readers.hpp"
#include "text.hpp"

namespace eyebridge::files {

world::ObjectSpec read_object_text(std::string_view text, const std::string& name) {
  std::vector<Warning> warnings;
  SimFile sim = read_sim(text, name, warnings);
  const bool anything_else = sim.world || !sim.robot_files.empty() || !sim.object_files.empty() ||
                             !sim.robots.empty() || !sim.markers.empty() || !sim.errors.empty() ||
                             sim.show_sensors || sim.show_trail;
  if (sim.objects.size() != 1 || anything_else) {
    throw ConfigError(
        {name, 1, 1},
        "expected the line of one object, and after it what more is to be said of it");
  }
  return std::move(sim.objects.front());
}

std::string write_object_text(const world::ObjectSpec& object) {
  SimFile sim;
  sim.objects.push_back(object);
  return write_sim(sim);
}

}  // namespace eyebridge::files
