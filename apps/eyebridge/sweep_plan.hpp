#pragma once

#include <set>
#include <string>
#include <vector>

#include "sweep/plan.hpp"
#include "sweep/run_cells.hpp"

namespace CLI {
class App;
}

namespace eyebridge::apps {

/// What `eyebridge sweep` was told on its command line.
struct SweepFlags {
  /// Settings as flags gave them, in order: key, value.
  std::vector<std::pair<std::string, std::string>> settings;
  std::vector<std::string> environment;  ///< NAME=VALUE
  std::vector<std::string> parameters;   ///< NAME=VALUE
  std::string results;
  std::string wall_limit;
  std::string jobs;
};

/// Adds the flags of a plan to `command`: a setting each but for those in `except`, --env,
/// --parameter, --wall-limit, --jobs. What is given lands in `flags`, which must outlive the
/// parsing.
void add_axis_flags(CLI::App& command, SweepFlags& flags, const std::set<std::string>& except = {});

/// The plan of `words` (a sweep file, or a program and its arguments, or nothing) and `flags`,
/// which take the place of what the file says. Throws ConfigError.
SweepPlan make_plan(const SweepFlags& flags, const std::vector<std::string>& words);

/// Makes the programs of `plan` absolute. Throws ConfigError where one cannot be started.
void find_programs(SweepPlan& plan);

/// What a sweep file asks for that the user has to agree to (Trust): programs outside of its
/// folder.
struct Asked {
  std::string text;
  SourceLocation where;  ///< In the sweep file.
};

/// For `plan`, whose programs have been found.
std::vector<Asked> asked_by(const SweepPlan& plan);

/// Everything that can be wrong before the first run: finds all programs, checks every combination
/// of settings as `eyebridge run` does. Makes paths in `plan` absolute and returns what all runs
/// have in common. Throws ConfigError.
RunSettings prepare(SweepPlan& plan);

}  // namespace eyebridge::apps
