#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>

#include "command.hpp"
#include "eyebridge/base/text.hpp"
#include "setting_flags.hpp"

namespace eyebridge::apps {

void add_config(CLI::App& root, int& code) {
  CLI::App* command =
      root.add_subcommand("config", "Shows every setting's value and where it came from");
  auto flags = std::make_shared<SettingFlags>();
  add_setting_flags(*command, *flags);
  auto program = std::make_shared<std::string>();
  command->add_option("program", *program, "Also look for eyebridge.toml beside this program")
      ->type_name("FILE");
  command->callback([flags, program, &code] {
    const std::string text = hal::Config::from_command_line(*program, *flags).describe();
    std::fputs(printable(text).c_str(), stdout);
    code = kFine;
  });
}

}  // namespace eyebridge::apps
