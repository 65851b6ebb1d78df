#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "eyebridge/hal/config.hpp"

namespace eyebridge::apps {

/// Finds the robot program `name`: with a slash as it stands, else in the working folder, else in
/// PATH. Throws ConfigError when there is none, or when it cannot be executed (a .py need only be
/// readable).
std::filesystem::path find_program(const std::string& name);

/// The executable file `name` in PATH; empty if there is none.
std::filesystem::path find_in_path(const std::string& name);

/// The Python that our compiled modules are for; in a virtual environment its own.
std::string python_of_modules();

/// Becomes the program words[0], a path or a name in PATH; Python finds our packages there, and a
/// robot program its settings in `config`, unless null. Throws ConfigError when the system refuses;
/// returns never.
[[noreturn]] void become(const std::vector<std::string>& words, const hal::Config* config);

}  // namespace eyebridge::apps
