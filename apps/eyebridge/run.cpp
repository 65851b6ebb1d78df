#include "run.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "check_settings.hpp"
#include "command.hpp"
#include "control_file.hpp"
#include "eyebridge/base/own_place.hpp"
#include "eyebridge/hal/shared_world.hpp"
#include "program.hpp"

namespace eyebridge::apps {
namespace {

/// Becomes the programs that the robots of a .sim file name; returns when there is no such file.
void run_scenario(SettingFlags flags) {
  const hal::Config config = hand_on(flags, {});
  if (config.path("world").extension() != ".sim") return;
  if (config.value("robots").is_default()) flags["robots"] = "all";
  check_settings(hand_on(flags, {}));
  // Of whichever generation they are: the launcher sees to that.
  become(plugin_folder() / "eyebridge-robots", {});
}

}  // namespace

void run_words(const std::string& command, const SettingFlags& flags,
               const std::vector<std::string>& words) {
  if (words.empty() && command == "run") run_scenario(flags);
  if (words.empty()) {
    throw ConfigError({command}, "found no program, expected: eyebridge " + command +
                                     (command == "run" ? "" : " FILE.ebrec") +
                                     " [OPTIONS] PROGRAM [ARGUMENTS]" +
                                     (command == "run" ? ", or --world FILE.sim whose robots name "
                                                         "their programs"
                                                       : ""));
  }
  const std::string& name = words.front();
  if (name.size() > 1 && name.front() == '-') {
    throw ConfigError({name},
                      "unknown option; eyebridge " + command + " --help lists those there are");
  }
  const auto program = find_program(name);
  const hal::Config config = hand_on(flags, program);
  check_settings(config);
  if (is_control_file(program)) {
    if (command != "run") {
      throw ConfigError({program.string()}, "found a control file, expected a robot program: " +
                                                command + " takes no control files");
    }
    become_control(program, {words.begin() + 1, words.end()});
  }
  if (is_python(program) && hal::programs_wanted(config) > 1) {
    // A binary sees to that itself.
    std::vector<std::string> all{program.string()};
    all.insert(all.end(), words.begin() + 1, words.end());
    become(plugin_folder() / "eyebridge-robots", all);
  }
  become(program, {words.begin() + 1, words.end()});
}

void add_run(CLI::App& root, int& /*code*/) {
  CLI::App* command = root.add_subcommand(
      "run", "Runs a robot program: eyebridge run [OPTIONS] PROGRAM [ARGUMENTS]");
  command->footer(
      "PROGRAM is an executable (see eyebridge-cc) or a Python file. Every option can also be\n"
      "an environment variable (EYEBRIDGE_WORLD) or a line of eyebridge.toml (world = \"...\").\n"
      "Without PROGRAM the robots of a .sim file run the programs that it names.");
  // The program's name ends our options: what follows belongs to it, whatever it looks like.
  command->prefix_command();
  auto flags = std::make_shared<SettingFlags>();
  add_setting_flags(*command, *flags);
  command->callback([command, flags] { run_words("run", *flags, command->remaining()); });
}

}  // namespace eyebridge::apps
