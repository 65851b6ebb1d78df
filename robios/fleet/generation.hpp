#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "dynamic_names.hpp"

namespace eyebridge::robios {

// There are two generations of RoBIOS, a library each. One process runs robots of one of them: each
// library has a world of its own.

/// True when a program is linked with the other library than the one that this code is in. A file
/// that cannot be read is not.
bool is_of_other_generation(const DynamicNames& names);
bool is_of_other_generation(const std::filesystem::path& program);

/// Becomes the launcher for programs of this library, or of the other one, with `words` (a program
/// and its arguments, or nothing). Throws ConfigError when the system refuses; returns never.
[[noreturn]] void become_launcher(bool other_generation, std::vector<std::string> words);

}  // namespace eyebridge::robios
