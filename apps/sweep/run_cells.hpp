#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "sweep/outcome.hpp"
#include "sweep/plan.hpp"

namespace eyebridge::apps {

/// What all runs of a sweep have in common.
struct RunSettings {
  std::filesystem::path command;            ///< `eyebridge`, absolute.
  std::filesystem::path folder;             ///< Absolute; each run gets one of its own below it.
  std::map<std::string, std::string> base;  ///< Settings that no axis sets.
  double wall_limit = 600;                  ///< Seconds.
  int jobs = 1;                             ///< Runs at a time.
  bool keep_files = false;                  ///< Of runs that ended well, too.
};

/// Runs `eyebridge run` once for each of `todo` (indices in `cells`), several at a time, each in a
/// folder, process group and time limit of its own, and calls `ended(index, outcome)` as they end.
/// A run that goes wrong in any way is an outcome like any other. When `stop()` holds, asked a few
/// times a second, what is running is ended and not reported. True when all ended.
///
/// One thread, which must live as long as the runs: they end with it. Throws std::system_error or
/// std::filesystem::filesystem_error when the system gives no process or folder at all.
bool run_cells(const std::vector<Cell>& cells, std::span<const std::size_t> todo,
               const RunSettings& settings,
               const std::function<void(std::size_t, const Outcome&)>& ended,
               const std::function<bool()>& stop);

}  // namespace eyebridge::apps
