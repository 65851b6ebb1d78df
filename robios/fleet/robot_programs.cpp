#include "robot_programs.hpp"

#include <algorithm>
#include <string_view>

#include "eyebridge/base/read_file.hpp"
#include "eyebridge/base/robot_program.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/base/trust.hpp"
#include "eyebridge/files/scenario_programs.hpp"
#include "program_file.hpp"

namespace eyebridge::robios {
namespace {

namespace fs = std::filesystem;

bool begins_with(const fs::path& file, std::string_view bytes) {
  return first_bytes(file, bytes.size()) == bytes;
}

}  // namespace

bool is_script(const fs::path& program) { return is_python(program) || begins_with(program, "#!"); }

bool needs_process(const fs::path& program, const hal::Config& config) {
  if (config.boolean("isolate") || is_script(program)) return true;
  if (!begins_with(program, "\177ELF")) return false;
  try {
    return !ProgramFile::of(program).own_library.empty() && !config.boolean("shared_globals");
  } catch (const ConfigError& error) {
    if (!config.boolean("shared_globals")) return true;
    throw ConfigError(error.where(), error.text() +
                                         ", so that they cannot share variables; leave out "
                                         "shared_globals, and each has a process of its own");
  }
}

void check_trust(const std::vector<hal::SharedRobot>& robots, const fs::path& scenario) {
  for (const hal::SharedRobot& robot : robots) {
    if (robot.program.empty()) continue;
    const auto asked = files::asked_for(robot.program, robot.arguments, scenario);
    if (!asked || Trust::of_user().covers(scenario, *asked)) continue;
    throw ConfigError({scenario.string()}, "found the program " + in_quotes(robot.program) +
                                               ", which lies outside of this file's folder" +
                                               how_to_trust(scenario));
  }
}

std::vector<RobotProgram> programs_of(const std::vector<hal::SharedRobot>& robots,
                                      const std::vector<std::string>& words,
                                      const fs::path& scenario) {
  if (!words.empty()) {
    if (const std::string why = trouble_with(words.front()); !why.empty()) {
      throw ConfigError({words.front()}, why);
    }
    return std::vector<RobotProgram>(robots.size(),
                                     {words.front(), {words.begin() + 1, words.end()}});
  }
  std::vector<RobotProgram> programs;
  for (const hal::SharedRobot& robot : robots) {
    programs.push_back(
        robot.program.empty()
            ? RobotProgram{}
            : RobotProgram{files::program_file(robot.program, scenario), robot.arguments});
  }
  const auto has_none = [](const RobotProgram& program) { return program.file.empty(); };
  if (!std::ranges::all_of(programs, has_none)) return programs;
  throw ConfigError({scenario.string()},
                    "found no robot with a program, expected 'S4 x y phi PROGRAM' in a .sim file, "
                    "or a program on the command line");
}

}  // namespace eyebridge::robios
