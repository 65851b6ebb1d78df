#pragma once

#include <filesystem>
#include <string>

#include "eyebridge/hal/config.hpp"

namespace eyebridge::hal {

/// The file that `world` (a value of the setting "world", not empty) means for a run of `program`
/// (may be empty): as files::find_file() finds it. A value out of a TOML file is looked for in that
/// file's folder first. Where there is no such file: the value's text.
std::string world_file(const ConfigValue& world, const std::filesystem::path& program);

/// As world_file(), but throws ConfigError where `world` was written if there is no such file.
std::filesystem::path find_world(const ConfigValue& world, const std::filesystem::path& program);

}  // namespace eyebridge::hal
