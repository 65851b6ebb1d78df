#pragma once

#include <string>
#include <vector>

#include "setting_flags.hpp"

namespace eyebridge::apps {

/// Becomes the program that `words` begin with, the others its arguments, with the settings in
/// `flags`: what `eyebridge run` does. `command` is the subcommand's name, for messages. Throws
/// ConfigError before anything is started; returns never.
[[noreturn]] void run_words(const std::string& command, const SettingFlags& flags,
                            const std::vector<std::string>& words);

}  // namespace eyebridge::apps
