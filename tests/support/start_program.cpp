#include "start_program.hpp"

#include <fcntl.h>
#include <spawn.h>

#include "eyebridge/base/exec_words.hpp"

namespace eyebridge::testing {

pid_t start_program(const ProgramStart& start, int out, int err) {
  std::map<std::string, std::string> changes = start.environment;
  // The leak checker must not blame programs for these.
  changes.try_emplace("LSAN_OPTIONS",
                      "print_suppressions=0:suppressions=" EYEBRIDGE_LSAN_SUPPRESSIONS);
  const std::vector<std::string> variables = environment_with(changes);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, out, 1);
  posix_spawn_file_actions_adddup2(&actions, err, 2);
  if (!start.directory.empty()) {
    posix_spawn_file_actions_addchdir_np(&actions, start.directory.c_str());
  }
  pid_t pid = -1;
  const int failed = posix_spawnp(&pid, start.command.at(0).c_str(), &actions, nullptr,
                                  pointers_to(start.command).data(), pointers_to(variables).data());
  posix_spawn_file_actions_destroy(&actions);
  return failed == 0 ? pid : -1;
}

}  // namespace eyebridge::testing
