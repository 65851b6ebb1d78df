#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "system_files.hpp"

namespace eyebridge::apps {

/// `device`, a path below `root`, without links: as programs there have it open.
std::string without_links(const std::string& device, const std::filesystem::path& root = "/");

/// Processes, but for this one, that have `device` open or locked, by id. `device` is its path
/// below `root`, with or without links: "/dev/ttyACM0". Looks at /proc/*/fd, which tells only of
/// one's own processes unless root asks, and at /proc/locks, which tells of all.
std::vector<Process> holders_of(const std::string& device, const std::filesystem::path& root = "/");

/// "minicom (process 812) and python3 (process 900)"; "" for none.
std::string listed(const std::vector<Process>& holders);

}  // namespace eyebridge::apps
