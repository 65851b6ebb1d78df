#pragma once

#include <filesystem>
#include <vector>

#include "machine/finding.hpp"

namespace eyebridge::apps {

/// Looks at compilers and our own files and parts, and below `root` at devices and drivers.
/// Changes nothing. With another root than "/" the kernel is not asked about CAN, whose state is in
/// no file.
std::vector<Finding> examine_machine(const std::filesystem::path& root = "/");

}  // namespace eyebridge::apps
