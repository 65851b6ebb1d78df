#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sweep/summary.hpp"

namespace eyebridge::apps {

/// Draws `value` of each group as a PNG: every run a dot, the mean a line, the deviation a bar.
/// Throws ConfigError when no run has the value (it names those there are), and std::runtime_error
/// when the file cannot be written.
void plot(const std::vector<Group>& groups, const std::string& value,
          const std::filesystem::path& file);

}  // namespace eyebridge::apps
