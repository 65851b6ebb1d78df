#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "ask_run.hpp"
#include "command.hpp"
#include "eyebridge/base/config_error.hpp"
#include "program.hpp"

namespace eyebridge::apps {
namespace {

namespace fs = std::filesystem;
using robios::Words;

constexpr const char* kForm =
    "expected eyebridge add [--run PID] MODEL x y phi [PROGRAM [ARGUMENTS]]";

/// As they are found from any folder.
Words resolved(Words words) {
  if (words.size() < 4) throw ConfigError({"add"}, kForm);
  if (fs::path(words[0]).extension() == ".robi") words[0] = fs::absolute(words[0]).string();
  if (words.size() > 4) words[4] = fs::absolute(find_program(words[4])).string();
  return words;
}

}  // namespace

void add_add(CLI::App& root, int& code) {
  CLI::App* command = root.add_subcommand(
      "add", "Adds a robot to a run: eyebridge add MODEL x y phi [PROGRAM [ARGUMENTS]]");
  command->footer(
      "Lets a robot enter the simulated world of a run on this computer, at x, y (mm) and phi\n"
      "(degrees), and prints its number. MODEL is a type that the world knows, a built-in one, or\n"
      "a .robi file; without PROGRAM the robot stands still. In virtual time it comes at\n"
      "whichever step is next: such a run cannot be repeated; `enters` in a .sim file can.");
  command->prefix_command();
  auto run = std::make_shared<int>(0);
  command->add_option("--run", *run, "The run's process, where there are several")
      ->check(CLI::PositiveNumber);
  command->callback(
      [command, run, &code] { code = ask_run("add", *run, resolved(command->remaining())); });
}

}  // namespace eyebridge::apps
