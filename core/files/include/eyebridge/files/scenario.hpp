#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/robot/robot_model.hpp"
#include "eyebridge/world/world_model.hpp"

namespace eyebridge::files {

/// What becomes of a line that cannot be.
enum class Reading {
  Strict,    ///< It is an error, and nothing is read.
  Tolerant,  ///< A warning says so, and the other lines count.
};

/// One robot as a scenario places it.
struct RobotPlacement {
  std::size_t model = 0;  ///< Index into Scenario::models.
  Pose pose;
  std::string program;  ///< Empty: started by hand.
  std::vector<std::string> arguments;

  friend bool operator==(const RobotPlacement&, const RobotPlacement&) = default;
};

/// A robot that enters while the world runs.
struct Newcomer {
  RobotPlacement robot;
  double time = 0.0;     ///< Seconds after the start.
  SourceLocation where;  ///< Of its line.
};

/// What a run starts from, whichever files it came from.
struct Scenario {
  std::filesystem::path directory;  ///< Where the files lie that it names.
  world::WorldModel world;
  std::vector<SourceLocation> start_places;  ///< Where each of world.starts was read.
  std::vector<robot::RobotModel> models;
  std::vector<RobotPlacement> robots;  ///< Those that are there from the start.
  std::vector<Newcomer> newcomers;     ///< In the order in which they enter.
  bool start_paused = false;           ///< eyesim.p: pause on
  bool show_sensors = false;           ///< .sim: settings VIS
  bool show_trail = false;             ///< .sim: settings TRACE
  std::vector<Warning> warnings;
};

}  // namespace eyebridge::files
