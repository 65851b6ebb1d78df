#pragma once

#include <string>
#include <vector>

#include "run_program.hpp"

namespace eyebridge::testing {

/// Runs `eyebridge` with `arguments` in `folder`; no eyebridge.toml or world of the
/// user's is seen.
inline ProgramRun run_command(const std::vector<std::string>& arguments, const std::string& folder,
                              std::map<std::string, std::string> environment = {}) {
  std::vector<std::string> command = {EYEBRIDGE_BIN "/eyebridge"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  environment.emplace("XDG_CONFIG_HOME", "/dev/null/none");
  environment.emplace("XDG_DATA_HOME", "/dev/null/none");
  return run_program({command, environment, folder});
}

/// Runs `script` with sh in `folder`, our commands first in PATH.
inline ProgramRun run_shell(const std::string& script, const std::string& folder) {
  return run_program({{"sh", "-euc", "PATH=" EYEBRIDGE_BIN ":$PATH\n" + script},
                      {{"EYEBRIDGE_FAST", "true"}},
                      folder});
}

}  // namespace eyebridge::testing
