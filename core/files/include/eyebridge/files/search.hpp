#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/files/load.hpp"

namespace eyebridge::files {

/// The file that `written` means in a file that lies in `directory`.
///
/// Looked for as given, relative to `directory`, to EyeSim's home and to the built-in worlds;
/// `%sim%` stands for EyeSim's home and backslashes for slashes. Throws ConfigError at `where`.
std::filesystem::path find_file(const std::string& written, const std::filesystem::path& directory,
                                const SearchPlaces& places, const SourceLocation& where);

/// The file that `written` means, in the first of `folders` that has it; "" is the working folder.
/// `%sim%` and backslashes as in find_file().
std::optional<std::filesystem::path> look_for(const std::string& written,
                                              const std::vector<std::filesystem::path>& folders,
                                              const SearchPlaces& places);

}  // namespace eyebridge::files
