#include <utility>

#include "eyebridge/files/readers.hpp"
#include "motion_lines.hpp"
#include "object_lines.hpp"
#include "text.hpp"

namespace eyebridge::files {

world::ObjectSpec read_object_text(std::string_view text, const std::string& name) {
  std::vector<Warning> warnings;
  SimFile sim = read_sim(text, name, warnings);
  const bool anything_else = sim.world || !sim.robot_files.empty() || !sim.object_files.empty() ||
                             !sim.robots.empty() || !sim.markers.empty() || !sim.errors.empty() ||
                             sim.show_sensors || sim.show_trail;
  if (sim.objects.empty() && sim.robots.size() == 1) {
    const std::string keyword = lower(sim.robots.front().model);
    if (keyword == "box" || keyword == "polygon") {
      throw ConfigError(sim.robots.front().where,
                        keyword == "box" ? "the box has no size: expected box x y phi length width"
                                         : "the polygon has no corners: expected polygon x y phi "
                                           "x1 y1 x2 y2 x3 y3 ...");
    }
  }
  if (sim.objects.size() != 1 || anything_else) {
    throw ConfigError(
        {name, 1, 1},
        "expected the line of one object, and after it what more is to be said of it");
  }
  return std::move(sim.objects.front());
}

world::ObjectSpec read_object_change(world::ObjectSpec object, std::string_view text,
                                     const std::string& name) {
  StatementReader statements(text, name);
  Statement s;
  bool has_way = false;  // by this text: it takes the place of what the object had
  while (statements.next(s)) {
    const std::string keyword = lower(s.text(0));
    if (!is_object_trait(keyword)) {
      s.fail(0, in_quotes(s.text(0)) + " found: expected what may follow the line of an object");
    }
    if (begins_way(keyword) && !std::exchange(has_way, true)) {
      object.path.reset();
      object.reaction.reset();
    }
    read_more(s, object);
  }
  return object;
}

std::string write_object_text(const world::ObjectSpec& object) {
  SimFile sim;
  sim.objects.push_back(object);
  // What has corners is as large as they say.
  if (!world::corners_of(object).empty()) sim.objects.back().radius = object.outer_radius();
  return write_sim(sim);
}

}  // namespace eyebridge::files
