#pragma once

#include <filesystem>
#include <string>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/files/load.hpp"

namespace eyebridge::files {

/// The file that `written` means in a file that lies in `directory`.
///
/// Looked for as given, relative to `directory`, to EyeSim's home and to the built-in worlds;
/// `%sim%` stands for EyeSim's home and backslashes for slashes. Throws ConfigError at `where`.
std::filesystem::path find_file(const std::string& written, const std::filesystem::path& directory,
                                const SearchPlaces& places, const SourceLocation& where);

}  // namespace eyebridge::files
