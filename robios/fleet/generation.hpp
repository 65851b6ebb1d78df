#pragma once

#include <filesystem>

namespace eyebridge::robios {

// There are two generations of RoBIOS, a library each. One process runs robots of one of them: each
// library has a world of its own.

/// True when `program` is linked with the other library than the one that this code is in. A file
/// that cannot be read is not.
bool is_of_other_generation(const std::filesystem::path& program);

/// The launcher for programs of this library, or of the other one.
std::filesystem::path launcher_of(bool other_generation);

}  // namespace eyebridge::robios
