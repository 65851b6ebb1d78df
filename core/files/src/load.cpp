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

enum class Kind { Ground, Sim, Robot, Parameters, Object };

Kind kind_of(const std::filesystem::path& path) {
  const std::string extension = lower(path.extension().string());
  if (extension == ".sim") return Kind::Sim;
  if (extension == ".robi") return Kind::Robot;
  if (extension == ".p") return Kind::Parameters;
  if (extension == ".esobj") return Kind::Object;
  return Kind::Ground;
}

void load_parameters(const std::filesystem::path& path, Scenario& scenario,
                     const LoadOptions& options) {
  const std::string name = path.string();
  const ParameterFile file = read_parameter_file(read_text_file(path), name, scenario.warnings);
  scenario.start_paused = file.pause;
  if (file.world || file.maze) {
    const std::string& written = file.world ? *file.world : *file.maze;
    const auto found = find_file_of_others(written, scenario.directory, options.places,
                                           file.world_where, scenario.warnings, options.reading);
    load_ground(found, file.world ? GroundKind::World : GroundKind::Maze, scenario, options);
  } else {
    scenario.world = empty_room();
    scenario.warnings.push_back({{name, 0, 0}, "no world or maze named: an empty room, 2 m x 2 m"});
  }
  Placer(scenario, options.reading).place_at_start(file.robot, {name, 0, 0});
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

/// Places the robot that the settings name, if there is none yet; where it is too big for a maze,
/// the message says which one is not.
void place_default(Scenario& scenario, const SourceLocation& where, const LoadOptions& options) {
  if (options.robot.empty() || !scenario.robots.empty()) return;
  const robot::RobotModel& robot = named_robot(options.robot, options.robot_where);
  try {
    Placer(scenario, options.reading).place_at_start(robot, where);
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

namespace {

void load(const std::filesystem::path& path, Scenario& scenario, const LoadOptions& options) {
  const std::string name = path.string();
  const SourceLocation where{name, 0, 0};
  const Reading reading = options.reading;
  switch (kind_of(path)) {
    case Kind::Parameters:
      return load_parameters(path, scenario, options);
    case Kind::Sim: {
      const auto errors = load_sim(read_text_file(path), name, scenario, options);
      place_default(scenario, where, options);
      return apply_rules_of_file(errors, scenario, reading);
    }
    case Kind::Robot: {
      scenario.world = empty_room();
      const auto robot = read_robi(read_text_file(path), name, scenario.warnings, reading);
      return Placer(scenario, reading).place_at_start(robot, where);
    }
    case Kind::Object: {
      const world::ObjectSpec object =
          read_object(read_text_file(path), name, path.stem().string(), scenario.warnings, reading);
      scenario.world = room_of(std::max(kRoom, 4 * object.radius));
      scenario.world.objects.push_back(object);
      scenario.world.objects.back().pose = {scenario.world.middle().x, scenario.world.middle().y,
                                            0};
      break;
    }
    case Kind::Ground: {
      const auto kind = ground_kind(path);
      if (!kind) {
        throw ConfigError(where,
                          "unknown kind of file: expected .wld, .maz, .sim, .robi, .esObj or .p, "
                          "a maze of a contest, a map (.yaml), .svg or .world");
      }
      load_ground(path, *kind, scenario, options);
      break;
    }
  }
  place_default(scenario, where, options);
}

}  // namespace

Scenario load_scenario(const std::filesystem::path& written, const LoadOptions& options) {
  std::error_code error;
  const std::filesystem::path path =
      std::filesystem::exists(written, error)
          ? written
          : find_file(written.string(), {}, options.places, {"world"});
  Scenario scenario;
  scenario.directory = path.parent_path();
  load(path, scenario, options);
  if (options.cell && !scenario.world.maze) {
    throw ConfigError(options.cell_where,
                      in_quotes(path.string(), 200) + " is no maze: only a maze has cells");
  }
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
