#pragma once

#include <filesystem>
#include <vector>

#include "machine/finding.hpp"

namespace eyebridge::apps {

/// What EyeBridge can do here besides running programs: windows, the Python module, MPI, rendered
/// pictures, the lab, sanitizers. Tries each out, as far as nothing changes by it. Kernel settings
/// are looked at below `root`.
std::vector<Finding> examine_parts(const std::filesystem::path& root);

/// The command `name` in PATH; where it is missing, `use` says what for, and `package` brings it.
Finding command_in_path(const char* name, bool needed, const char* use, const char* package);

}  // namespace eyebridge::apps
