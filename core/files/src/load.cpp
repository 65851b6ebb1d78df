#include "eyebridge/files/load.hpp"

#include <algorithm>
#include <system_error>

#include "builtin.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/files/readers.hpp"
#include "eyebridge/files/search.hpp"
#include "ground.hpp"
#include "placement.hpp"
#include "sim_loader.hpp"
#include "text.hpp"

namespace eyebridge::files {
namespace {

constexpr double kRoom = 2.0;  // metres, EyeSim's default

enum class Kind { World, Maze, Sim, Robot, Parameters, Object, Unknown };

Kind kind_of(const std::filesystem::path& path) {
  const std::string extension = lower(path.extension().string());
  if (extension == ".wld") return Kind::World;
  if (extension == ".maz") return Kind::Maze;
  if (extension == ".sim") return Kind::Sim;
  if (extension == ".robi") return Kind::Robot;
  if (extension == ".p") return Kind::Parameters;
  if (extension == ".esobj") return Kind::Object;
  return Kind::Unknown;
}

void load_parameters(const std::filesystem::path& path, const SearchPlaces& places,
                     Scenario& scenario, Reading reading) {
  const std::string name = path.string();
  const ParameterFile file = read_parameter_file(read_text_file(path), name, scenario.warnings);
  scenario.start_paused = file.pause;
  if (file.world || file.maze) {
    const std::string& written = file.world ? *file.world : *file.maze;
    const auto found = find_file_of_others(written, scenario.directory, places, file.world_where,
                                           scenario.warnings, reading);
    load_ground(found, file.world ? GroundKind::World : GroundKind::Maze, places, scenario,
                reading);
  } else {
    scenario.world = empty_room();
    scenario.warnings.push_back({{name, 0, 0}, "no world or maze named: an empty room, 2 m x 2 m"});
  }
  Placer(scenario, reading).place_at_start(file.robot, {name, 0, 0});
}

/// Whether `robot` could be the only one in `scenario`.
bool has_room_for(const robot::RobotModel& robot, const Scenario& scenario) {
  Scenario trial;
  trial.world = scenario.world;
  trial.start_places = scenario.start_places;
  try {
    Placer(trial).place_at_start(robot, {});
    return true;
  } catch (const ConfigError&) {
    return false;
  }
}

/// Places the robot that the settings name; where it is too big for a maze, the message says which
/// one is not.
void place_default(Scenario& scenario, const robot::RobotModel& robot, const SourceLocation& where,
                   Reading reading) {
  try {
    Placer(scenario, reading).place_at_start(robot, where);
  } catch (const ConfigError& error) {
    if (!scenario.world.maze || !has_room_for(*builtin_robot("Mouse"), scenario)) throw;
    throw ConfigError(error.where(), error.text() + "; a smaller robot fits: --robot Mouse");
  }
}

/// With walls around it; `size` in metres.
world::WorldModel room_of(double size) {
  world::WorldModel room;
  room.width = room.height = size;
  room.walls = world::walls_around(size, size);
  for (world::Wall& wall : room.walls) wall.thickness = world::Wall::kFileThickness;
  return room;
}

void apply_rules_of_file(const std::vector<ErrorRule>& rules, Scenario& scenario, Reading reading) {
  if (reading == Reading::Strict) return apply_rules(rules, scenario);
  for (const ErrorRule& rule : rules) {
    try {
      apply_rules({&rule, 1}, scenario);
    } catch (const ConfigError& error) {
      scenario.warnings.push_back({error.where(), error.text() + "; the line is left out"});
    }
  }
}

}  // namespace

world::WorldModel empty_room() { return room_of(kRoom); }

Scenario load_scenario(const std::filesystem::path& written, const std::string& default_robot,
                       const SearchPlaces& places, const SourceLocation& robot_where,
                       Reading reading) {
  std::error_code error;
  const std::filesystem::path path = std::filesystem::exists(written, error)
                                         ? written
                                         : find_file(written.string(), {}, places, {"world"});
  const std::string name = path.string();
  Scenario scenario;
  scenario.directory = path.parent_path();
  const Kind kind = kind_of(path);
  if (kind == Kind::Unknown) {
    throw ConfigError({name, 0, 0},
                      "unknown kind of file: expected .wld, .maz, .sim, .robi, .esObj or .p");
  }
  if (kind == Kind::Parameters) {
    load_parameters(path, places, scenario, reading);
    return scenario;
  }
  if (kind == Kind::Sim) {
    const auto errors = load_sim(read_text_file(path), name, places, scenario, reading);
    if (scenario.robots.empty()) {
      place_default(scenario, named_robot(default_robot, robot_where), {name, 0, 0}, reading);
    }
    apply_rules_of_file(errors, scenario, reading);
    return scenario;
  } else if (kind == Kind::Object) {
    const world::ObjectSpec object =
        read_object(read_text_file(path), name, path.stem().string(), scenario.warnings, reading);
    scenario.world = room_of(std::max(kRoom, 4 * object.radius));
    scenario.world.objects.push_back(object);
    scenario.world.objects.back().pose = {scenario.world.width / 2, scenario.world.height / 2, 0};
  } else if (kind == Kind::Robot) {
    scenario.world = empty_room();
    const auto robot = read_robi(read_text_file(path), name, scenario.warnings, reading);
    Placer(scenario, reading).place_at_start(robot, {name, 0, 0});
    return scenario;
  } else {
    load_ground(path, kind == Kind::World ? GroundKind::World : GroundKind::Maze, places, scenario,
                reading);
  }
  place_default(scenario, named_robot(default_robot, robot_where), {name, 0, 0}, reading);
  return scenario;
}

const robot::RobotModel& named_robot(std::string_view name, const SourceLocation& where) {
  const robot::RobotModel* robot = builtin_robot(name);
  if (robot != nullptr) return *robot;
  throw ConfigError(where,
                    "no robot " + in_quotes(name) + ": expected " + std::string(builtin_names()));
}

Scenario default_scenario() {
  Scenario scenario;
  scenario.world = empty_room();
  Placer(scenario).place_at_start(*builtin_robot("S4"), {"default world", 0, 0});
  return scenario;
}

}  // namespace eyebridge::files
