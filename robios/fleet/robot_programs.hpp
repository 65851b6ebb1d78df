#pragma once

#include <string>
#include <vector>

#include "eyebridge/hal/shared_world.hpp"
#include "robot.hpp"

namespace eyebridge::robios {

/// What each of `robots` runs: `words` (a program's file and its arguments) when there are any,
/// else what the scenario `where` names for it. A program that the scenario names is looked for
/// beside the scenario, then in the working folder; `explorer.x` may also be called `explorer`. An
/// empty file means that the robot has none: it stands still. Throws ConfigError when none has one,
/// and when `words` name no file.
std::vector<RobotProgram> programs_of(const std::vector<hal::SharedRobot>& robots,
                                      const std::vector<std::string>& words,
                                      const std::filesystem::path& scenario);

/// Throws ConfigError where the file `scenario` names a program for one of `robots` that lies
/// outside of its folder, and the user has not agreed (Trust).
void check_trust(const std::vector<hal::SharedRobot>& robots,
                 const std::filesystem::path& scenario);

/// True for a Python program, and for one that begins with #!.
bool is_script(const std::filesystem::path& program);

/// True for a program that runs in a process of its own: each where `config` says so (isolate), a
/// script, or a binary that ProgramFile refuses, or that has libraries of its own. Throws
/// ConfigError when a binary is to share its variables and cannot.
bool needs_process(const std::filesystem::path& program, const hal::Config& config);

}  // namespace eyebridge::robios
