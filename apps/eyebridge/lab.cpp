#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "command.hpp"
#include "eyebridge/base/config_error.hpp"
#include "own_files.hpp"
#include "program.hpp"

namespace eyebridge::apps {
namespace {

struct LabFlags {
  bool time_travel = false;
  bool vivid = false;
  std::vector<std::string> shares;
  std::vector<std::string> modules;
  std::string timeout;
  std::string memory;
  std::vector<std::string> command;
};

[[noreturn]] void lab(const LabFlags& flags) {
  const std::filesystem::path script = own_files().lab / "run";
  if (!std::filesystem::exists(script)) {
    throw ConfigError({script.string()}, "the lab is not here: the installation is not complete");
  }
  std::vector<std::string> words = {script.string()};
  if (flags.time_travel) words.emplace_back("--time-travel");
  if (flags.vivid) words.emplace_back("--vivid");
  const auto add = [&](const char* option, const std::string& value) {
    if (!value.empty()) words.insert(words.end(), {option, value});
  };
  for (const std::string& folder : flags.shares) add("--rw", folder);
  for (const std::string& module : flags.modules) add("--module", module);
  add("--timeout", flags.timeout);
  add("--memory", flags.memory);
  words.emplace_back("--");
  words.insert(words.end(), flags.command.begin(), flags.command.end());
  become(words, nullptr);
}

}  // namespace

void add_lab(CLI::App& root, int& /*code*/) {
  CLI::App* command = root.add_subcommand(
      "lab", "Runs a command on a kernel with CAN and V4L2, where this one has none");
  const auto flags = std::make_shared<LabFlags>();
  command->add_flag("--time-travel", flags->time_travel, "Simulated time: waiting takes none");
  command->add_flag("--vivid", flags->vivid, "With a simulated camera, /dev/video0");
  command->add_option("--rw", flags->shares, "What is written below FOLDER reaches the host")
      ->allow_extra_args(false)  // else it would eat the --
      ->type_name("FOLDER");
  command->add_option("--module", flags->modules, "Loads a kernel module: v4l2loopback")
      ->allow_extra_args(false)  // else it would eat the --
      ->type_name("\"NAME OPTION=VALUE...\"");
  command->add_option("--timeout", flags->timeout, "Ends it after so long (120)")
      ->type_name("SECONDS");
  command->add_option("--memory", flags->memory, "Of the guest (512)")->type_name("MB");
  command->add_option("COMMAND", flags->command, "Program and arguments, after --")
      ->required()
      ->allow_extra_args()
      ->type_name("");
  command->footer(
      "eyebridge lab -- COMMAND [ARGUMENT]...: vcan0 and vcan1 (CAN FD) are up, the host's files "
      "are\n"
      "there; what is written stays in the guest. The exit code is the command's; 124 after the\n"
      "time-out, 125 when the lab does not work or its kernel is not built yet (the message names\n"
      "the script that builds it).");
  command->callback([flags] { lab(*flags); });
}

}  // namespace eyebridge::apps
