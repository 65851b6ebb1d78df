#include "eyebridge/files/load.hpp"

#include "builtin.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/files/readers.hpp"
#include "placement.hpp"
#include "search.hpp"
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
    const auto found = find_file(written, scenario.directory, places, {name, 0, 0});
    const std::string text = read_text_file(found);
    scenario.world = file.world ? read_world(text, found.string(), scenario.warnings)
                                : read_maze(text, found.string(), scenario.warnings);
  } else {
    scenario.world = empty_room();
    scenario.warnings.push_back({{name, 0, 0}, "no world or maze named: an empty room, 2 m x 2 m"});
  }
  place_at_start(scenario, file.robot, {name, 0, 0});
}

}  // namespace

world::WorldModel empty_room() {
  world::WorldModel room;
  room.width = room.height = kRoom;
  const Vec2 corners[] = {{0, 0}, {kRoom, 0}, {kRoom, kRoom}, {0, kRoom}};
  for (std::size_t i = 0; i < 4; ++i) {
    world::Wall wall;
    wall.a = corners[i];
    wall.b = corners[(i + 1) % 4];
    room.walls.push_back(wall);
  }
  return room;
}

void place(Scenario& scenario, std::size_t model, const Pose& pose, const SourceLocation& where) {
  const robot::RobotModel& robot = scenario.models[model];
  if (const auto obstacle = obstacle_at(scenario, pose.position(), robot.radius())) {
    throw ConfigError(where, robot.name + " (" + write_millimetres(robot.diameter) +
                                 " mm across) at (" + write_millimetres(pose.x) + ", " +
                                 write_millimetres(pose.y) + ") mm stands in " + *obstacle +
                                 ": expected a free place");
  }
  const world::WorldModel& world = scenario.world;
  if (pose.x < 0 || pose.y < 0 || pose.x > world.width || pose.y > world.height) {
    scenario.warnings.push_back({where, robot.name + " stands outside the floor"});
  }
  RobotPlacement placement;
  placement.model = model;
  placement.pose = pose;
  scenario.robots.push_back(placement);
}

void place_at_start(Scenario& scenario, const robot::RobotModel& robot,
                    const SourceLocation& where) {
  scenario.models.push_back(robot);
  const std::size_t model = scenario.models.size() - 1;
  if (!scenario.world.starts.empty()) {
    place(scenario, model, scenario.world.starts.front().pose, where);
    return;
  }
  place_anywhere(scenario, model, where);
}

void place_anywhere(Scenario& scenario, std::size_t model, const SourceLocation& where) {
  const robot::RobotModel& robot = scenario.models[model];
  const auto free = free_place(scenario, robot.radius());
  if (!free) {
    throw ConfigError(where, "no free place for " + robot.name + " (" +
                                 write_millimetres(robot.diameter) +
                                 " mm across): expected room for a robot");
  }
  place(scenario, model, {free->x, free->y, 0}, where);
}

Scenario load_scenario(const std::filesystem::path& path, const std::string& default_robot,
                       const SearchPlaces& places) {
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
  const std::string text = read_text_file(path);
  if (kind == Kind::Sim) {
    load_sim(text, name, places, scenario);
    if (!scenario.robots.empty()) return scenario;
  } else if (kind == Kind::Robot) {
    scenario.world = empty_room();
    place_at_start(scenario, read_robi(text, name, scenario.warnings), {name, 0, 0});
    return scenario;
  } else {
    scenario.world = kind == Kind::World ? read_world(text, name, scenario.warnings)
                                         : read_maze(text, name, scenario.warnings);
  }
  const robot::RobotModel* robot = builtin_robot(default_robot);
  if (robot == nullptr) {
    throw ConfigError({"default robot", 0, 0}, "no robot " + in_quotes(default_robot) +
                                                   ": expected " + std::string(builtin_names()));
  }
  place_at_start(scenario, *robot, {name, 0, 0});
  return scenario;
}

Scenario default_scenario() {
  Scenario scenario;
  scenario.world = empty_room();
  place_at_start(scenario, *builtin_robot("S4"), {"default world", 0, 0});
  return scenario;
}

}  // namespace eyebridge::files
