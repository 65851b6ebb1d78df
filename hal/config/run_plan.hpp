#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "eyebridge/hal/config.hpp"

namespace eyebridge::hal {

/// Stands for every fingerprint.
inline constexpr const char* kAnySources = "any";

/// A configuration on its way to another process.
struct RunPlan {
  std::string sources;  ///< Fingerprint of what it was loaded from, or kAnySources.
  std::map<std::string, ConfigValue, std::less<>> values;  ///< By key; a default may be missing.

  /// Whether loading from sources with this fingerprint gives these values.
  [[nodiscard]] bool holds_for(std::string_view fingerprint) const {
    return sources == kAnySources || sources == fingerprint;
  }
};

/// Of the process, its variables EYEBRIDGE_* without the plan, and the places of eyebridge.toml.
std::string fingerprint(const Config::Sources& sources);

/// The fingerprint, then a line for each value that is not a default, its fields separated by
/// tabs: key=value, file, line, column. In fields \\, \n and \t stand for a backslash, a line end
/// and a tab.
std::string run_plan_text(const RunPlan& plan);

/// Throws ConfigError for what run_plan_text() does not write.
RunPlan read_run_plan(std::string_view text);

}  // namespace eyebridge::hal
