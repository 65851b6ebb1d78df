#include "run.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "check_settings.hpp"
#include "command.hpp"
#include "control_file.hpp"
#include "eyebridge/base/own_place.hpp"
#include "eyebridge/base/robot_program.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/base/trust.hpp"
#include "program.hpp"

namespace eyebridge::apps {
namespace {

/// Becomes the launcher of several robots, of whichever generation: it sees to that.
[[noreturn]] void become_launcher(std::vector<std::string> words, const hal::Config& config) {
  words.insert(words.begin(), (plugin_folder() / "eyebridge-robots").string());
  become(words, &config);
}

/// Becomes the programs that the robots of a .sim file name; returns when there is no such file.
void run_scenario(const SettingFlags& flags) {
  hal::Config config = hal::Config::from_command_line({}, flags);
  const hal::ConfigValue& world = config.value("world");
  if (config.path("world").extension() != ".sim") return;
  // Its programs are to be started: a folder's file may name those of its own folder only.
  if (world.where.line > 0 && !hal::is_users_own(world.where.file) &&
      !is_within(world.text, std::filesystem::path(world.where.file).parent_path())) {
    throw ConfigError(world.where, "found " + in_quotes(world.text) +
                                       " outside of this file's folder, whose programs would be "
                                       "started; expected --world " +
                                       world.text);
  }
  if (config.value("robots").is_default()) config = config.with("robots", {"all", {"--robots"}});
  check_settings(config);
  become_launcher({}, config);
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
  const hal::Config config = hal::Config::from_command_line(program, flags);
  const std::vector<std::string> arguments(words.begin() + 1, words.end());
  const bool several = check_settings(config);
  std::vector<std::string> all{program.string()};
  all.insert(all.end(), arguments.begin(), arguments.end());
  if (is_control_file(program)) {
    if (command != "run") {
      throw ConfigError({program.string()}, "found a control file, expected a robot program: " +
                                                command + " takes no control files");
    }
    // -P: a folder `eyebridge` where the user is is not our package.
    all.insert(all.begin(), {python_of_modules(), "-P", "-m", "eyebridge.control"});
    become(all, &config);
  }
  // A binary sees to that itself.
  if (is_python(program) && several) become_launcher(std::move(all), config);
  become(words_to_start(program, arguments), &config);
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
