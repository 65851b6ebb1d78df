#include "start_program.hpp"

#include <fcntl.h>
#include <spawn.h>

extern char** environ;

namespace eyebridge::testing {
namespace {

/// This process's environment and `more`, as "NAME=VALUE"; and what the leak checker must not blame
/// programs for.
std::vector<std::string> environment_with(std::map<std::string, std::string> more) {
  more.try_emplace("LSAN_OPTIONS",
                   "print_suppressions=0:suppressions=" EYEBRIDGE_LSAN_SUPPRESSIONS);
  std::vector<std::string> all;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    if (!more.contains(text.substr(0, text.find('=')))) all.push_back(text);
  }
  for (const auto& [name, value] : more) all.push_back(name + "=" + value);
  return all;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

}  // namespace

pid_t start_program(const ProgramStart& start, int out, int err) {
  std::vector<std::string> words = start.command;
  std::vector<std::string> variables = environment_with(start.environment);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, out, 1);
  posix_spawn_file_actions_adddup2(&actions, err, 2);
  if (!start.directory.empty()) {
    posix_spawn_file_actions_addchdir_np(&actions, start.directory.c_str());
  }
  pid_t pid = -1;
  const int failed = posix_spawnp(&pid, words.at(0).c_str(), &actions, nullptr,
                                  pointers(words).data(), pointers(variables).data());
  posix_spawn_file_actions_destroy(&actions);
  return failed == 0 ? pid : -1;
}

}  // namespace eyebridge::testing
