#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sweep/plan.hpp"

namespace eyebridge::apps {

/// How the cells of a plan are run.
struct RunChoices {
  bool retry = false;                      ///< Those that went wrong before, too.
  bool keep = false;                       ///< Keeps the files of all runs in RESULTS.runs.
  std::string results_flag = "--results";  ///< What names another file, for messages.
};

/// Checks everything that can be wrong before the first run, runs the cells of `plan` that its
/// results do not hold yet - here, or on the other ranks where mpirun started us - and, once all
/// are in, calls `show(plan, cells)` with the plan's paths absolute. Says on standard error how far
/// it is. Gives the exit code. Throws ConfigError.
int run_plan(SweepPlan plan, const RunChoices& choices,
             const std::function<void(const SweepPlan&, const std::vector<Cell>&)>& show);

}  // namespace eyebridge::apps
