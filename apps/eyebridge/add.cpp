#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "command.hpp"
#include "door_socket.hpp"
#include "eyebridge/base/config_error.hpp"
#include "program.hpp"

namespace eyebridge::apps {
namespace {

namespace fs = std::filesystem;
using robios::Words;

constexpr const char* kForm =
    "expected eyebridge add [--run PID] MODEL x y phi [PROGRAM [ARGUMENTS]]";

/// The door of the run `wanted`, or of the only one when that is 0.
UniqueFd find_run(pid_t wanted) {
  if (wanted != 0) {
    UniqueFd door = robios::knock(wanted);
    if (door.valid()) return door;
    throw ConfigError({"--run"}, fmt::format("found {}, expected the process of a run of several "
                                             "robots",
                                             wanted));
  }
  UniqueFd found;
  std::vector<pid_t> there;
  for (const pid_t pid : robios::doors()) {
    UniqueFd door = robios::knock(pid);
    if (!door.valid()) continue;
    there.push_back(pid);
    found = std::move(door);
  }
  if (there.size() == 1) return found;
  if (there.empty()) {
    throw ConfigError({"add"},
                      "found no run of several robots (--robots, or a .sim file whose "
                      "robots name their programs), expected one of this user");
  }
  throw ConfigError({"add"}, fmt::format("found {} runs, expected one: --run {} says which",
                                         there.size(), fmt::join(there, " or --run ")));
}

/// As they are found from any folder.
Words resolved(Words words) {
  if (words.size() < 4) throw ConfigError({"add"}, kForm);
  if (fs::path(words[0]).extension() == ".robi") words[0] = fs::absolute(words[0]).string();
  if (words.size() > 4) words[4] = fs::absolute(find_program(words[4])).string();
  return words;
}

int ask(pid_t wanted, const Words& words) {
  const Words request = resolved(words);
  const UniqueFd door = find_run(wanted);
  if (!robios::send_words(door, request)) {
    throw ConfigError({"add"}, fmt::format("the run could not be told: expected at most {} bytes "
                                           "of words, and a run that has not ended",
                                           robios::kLongestMessage));
  }
  const auto answer = robios::receive_words(door);
  if (!answer || answer->size() != 2) {
    std::fprintf(stderr, "eyebridge: the run has ended\n");
    return kFailed;
  }
  if (answer->front() == "ok") {
    std::printf("%s\n", answer->back().c_str());
    return kFine;
  }
  std::fprintf(stderr, "eyebridge: %s\n", answer->back().c_str());
  return kFailed;
}

}  // namespace

void add_add(CLI::App& root, int& code) {
  CLI::App* command = root.add_subcommand(
      "add", "Adds a robot to a run: eyebridge add MODEL x y phi [PROGRAM [ARGUMENTS]]");
  command->footer(
      "Lets a robot enter the world of a run of several robots on this computer, at x, y (mm) and\n"
      "phi (degrees), and prints its number. MODEL is a type that the world knows, a built-in "
      "one,\n"
      "or a .robi file; without PROGRAM the robot stands still. In virtual time it comes at\n"
      "whichever step is next: such a run cannot be repeated; `enters` in a .sim file can.");
  command->prefix_command();
  auto run = std::make_shared<int>(0);
  command->add_option("--run", *run, "The run's process, where there are several")
      ->check(CLI::PositiveNumber);
  command->callback([command, run, &code] { code = ask(*run, command->remaining()); });
}

}  // namespace eyebridge::apps
