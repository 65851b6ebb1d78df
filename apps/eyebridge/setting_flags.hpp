#pragma once

#include <map>
#include <string>

#include "eyebridge/hal/config.hpp"

namespace CLI {
class App;
}

namespace eyebridge::apps {

/// Values of settings as flags gave them: key -> text.
using SettingFlags = std::map<std::string, std::string>;

/// Adds a flag to `command` for every row of hal::settings(), and --sim, which is --world. What is
/// given lands in `flags`, which must outlive the parsing; the last one of a flag wins.
void add_setting_flags(CLI::App& command, SettingFlags& flags);

/// The word that says in --help what the values of `setting` are: WORLD, FOLDER, "auto|on|off".
std::string setting_type(const hal::Setting& setting);

}  // namespace eyebridge::apps
