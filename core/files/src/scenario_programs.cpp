#include "eyebridge/files/scenario_programs.hpp"

#include <algorithm>
#include <system_error>

#include "eyebridge/base/one_line.hpp"
#include "eyebridge/base/trust.hpp"

namespace eyebridge::files {
namespace fs = std::filesystem;

fs::path program_file(const std::string& name, const fs::path& scenario) {
  fs::path written(name);
  for (const fs::path& path : {written, fs::path(written).replace_extension()}) {
    for (const fs::path& folder : {scenario.parent_path(), fs::path()}) {
      std::error_code ignored;  // a folder that may not be searched holds nothing for us
      if (fs::is_regular_file(folder / path, ignored)) return folder / path;
    }
  }
  return written;
}

std::optional<std::string> asked_for(const std::string& name,
                                     const std::vector<std::string>& arguments,
                                     const fs::path& scenario) {
  const fs::path file = program_file(name, scenario);
  std::error_code error;
  if (!fs::exists(file, error) || is_within(file, scenario.parent_path())) return std::nullopt;
  const fs::path found = fs::canonical(file, error);
  std::string asked =
      "program = " + as_one_word((error ? fs::absolute(file, error) : found).string());
  for (const std::string& argument : arguments) asked += ' ' + as_one_word(argument);
  return asked;
}

std::vector<std::string> asked_by(const Scenario& scenario, const fs::path& file) {
  std::vector<std::string> all;
  const auto add = [&](const RobotPlacement& robot) {
    if (robot.program.empty()) return;
    auto asked = asked_for(robot.program, robot.arguments, file);
    if (asked && std::ranges::find(all, *asked) == all.end()) all.push_back(std::move(*asked));
  };
  for (const RobotPlacement& robot : scenario.robots) add(robot);
  for (const Newcomer& newcomer : scenario.newcomers) add(newcomer.robot);
  return all;
}

}  // namespace eyebridge::files
