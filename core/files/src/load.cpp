#include "eyebridge/files/load.hpp"

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

enum class Kind { World, Maze, Sim, Robot, Parameters, Unknown };

Kind kind_of(const std::filesystem::path& path) {
  const std::string extension = lower(path.extension().string());
  if (extension == ".wld") return Kind::World;
  if (extension == ".maz") return Kind::Maze;
  if (extension == ".sim") return Kind::Sim;
  if (extension == ".robi") return Kind::Robot;
  if (extension == ".p") return Kind::Parameters;
  return Kind::Unknown;
}

void load_parameters(const std::filesystem::path& path, const SearchPlaces& places,
                     Scenario& scenario) {
  const std::string name = path.string();
  const ParameterFile file = read_parameter_file(read_text_file(path), name, scenario.warnings);
  scenario.start_paused = file.pause;
  if (file.world || file.maze) {
    const std::string& written = file.world ? *file.world : *file.maze;
    const auto found = find_file(written, scenario.directory, places, file.world_where);
    load_ground(found, file.world ? GroundKind::World : GroundKind::Maze, places, scenario);
  } else {
    scenario.world = empty_room();
    scenario.warnings.push_back({{name, 0, 0}, "no world or maze named: an empty room, 2 m x 2 m"});
  }
  Placer(scenario).place_at_start(file.robot, {name, 0, 0});
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
void place_default(Scenario& scenario, const robot::RobotModel& robot,
                   const SourceLocation& where) {
  try {
    Placer(scenario).place_at_start(robot, where);
  } catch (const ConfigError& error) {
    if (!scenario.world.maze || !has_room_for(*builtin_robot("Mouse"), scenario)) throw;
    throw ConfigError(error.where(), error.text() + "; a smaller robot fits: --robot Mouse");
  }
}

}  // namespace

world::WorldModel empty_room() {
  world::WorldModel room;
  room.width = room.height = kRoom;
  room.walls = world::walls_around(kRoom, kRoom);
  return room;
}

Scenario load_scenario(const std::filesystem::path& written, const std::string& default_robot,
                       const SearchPlaces& places, const SourceLocation& robot_where) {
  std::error_code error;
  const std::filesystem::path path = std::filesystem::exists(written, error)
                                         ? written
                                         : find_file(written.string(), {}, places, {"world"});
  const std::string name = path.string();
  Scenario scenario;
  scenario.directory = path.parent_path();
  const Kind kind = kind_of(path);
  if (kind == Kind::Unknown) {
    throw ConfigError({name, 0, 0}, "unknown kind of file: expected .wld, .maz, .sim, .robi or .p");
  }
  if (kind == Kind::Parameters) {
    load_parameters(path, places, scenario);
    return scenario;
  }
  if (kind == Kind::Sim) {
    const auto errors = load_sim(read_text_file(path), name, places, scenario);
    if (scenario.robots.empty()) {
      place_default(scenario, named_robot(default_robot, robot_where), {name, 0, 0});
    }
    apply_rules(errors, scenario);
    return scenario;
  } else if (kind == Kind::Robot) {
    scenario.world = empty_room();
    const auto robot = read_robi(read_text_file(path), name, scenario.warnings);
    Placer(scenario).place_at_start(robot, {name, 0, 0});
    return scenario;
  } else {
    load_ground(path, kind == Kind::World ? GroundKind::World : GroundKind::Maze, places, scenario);
  }
  place_default(scenario, named_robot(default_robot, robot_where), {name, 0, 0});
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
