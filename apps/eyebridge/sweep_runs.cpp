#include "sweep_runs.hpp"

#include <chrono>
#include <cstdio>
#include <memory>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

#include "command.hpp"
#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/log.hpp"
#include "eyebridge/base/own_place.hpp"
#include "stop_signals.hpp"
#include "sweep/progress.hpp"
#include "sweep/ranks.hpp"
#include "sweep/results.hpp"
#include "sweep_plan.hpp"

namespace eyebridge::apps {
namespace {

/// Programs and worlds whose change would make runs another thing.
void note_inputs(ResultsFile& results, const SweepPlan& plan) {
  for (const Axis& axis : plan.axes) {
    const bool is_world = axis.kind == AxisKind::Setting && axis.name == "world";
    if (axis.kind != AxisKind::Program && !is_world) continue;
    for (const AxisValue& value : axis.values) {
      if (!value.text.empty()) results.note_input(value.text);
    }
  }
}

std::vector<std::size_t> missing(const std::vector<Cell>& cells,
                                 const std::set<std::string>& keys) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!keys.contains(cells[i].key())) out.push_back(i);
  }
  return out;
}

/// All that can be wrong before the first run is in `problem`, so that ranks can tell each other.
struct Prepared {
  std::vector<Cell> cells;
  RunSettings settings;
  std::string problem;
};

Prepared prepare_all(SweepPlan& plan, const RunChoices& choices) {
  Prepared out;
  try {
    out.settings = prepare(plan);
    out.settings.keep_files = choices.keep;
    out.cells = cells_of(plan);
  } catch (const ConfigError& error) {
    out.problem = error.what();
  }
  return out;
}

/// Runs what is missing, here or on the other ranks of `link`.
bool run_missing(const SweepPlan& plan, const RunChoices& choices, const Prepared& prepared,
                 ResultsFile& results, RankLink* link) {
  const std::vector<Cell>& cells = prepared.cells;
  const std::vector<std::size_t> todo = missing(cells, results.keys(choices.retry));
  const auto began = std::chrono::steady_clock::now();
  Progress progress(stderr, isatty(STDERR_FILENO) == 1, cells.size(), cells.size() - todo.size());
  std::size_t done = 0;
  const auto ended = [&](std::size_t cell, const Outcome& outcome) {
    results.add(cells[cell], outcome);
    ++done;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - began;
    progress.ended(cells[cell], outcome, elapsed.count());
  };
  const bool all = link != nullptr ? run_on_ranks(*link, todo, ended, stop_asked)
                                   : run_cells(cells, todo, prepared.settings, ended, stop_asked);
  progress.finish();
  std::error_code still_in_use;  // by files of runs that went wrong, which may tell why
  std::filesystem::remove(prepared.settings.folder, still_in_use);
  if (all) return true;
  tell(fmt::format("interrupted with {} of {} runs in {}; the same command goes on",
                   cells.size() - todo.size() + done, cells.size(), plan.results));
  return false;
}

}  // namespace

int run_plan(SweepPlan plan, const RunChoices& choices,
             const std::function<void(const SweepPlan&, const std::vector<Cell>&)>& show) {
  std::unique_ptr<RankLink> link =
      open_rank_link((plugin_folder() / "libeyebridge_mpi.so").string());
  if (link && link->size() == 1) link.reset();
  Prepared prepared = prepare_all(plan, choices);
  stop_on_signals();
  if (link && link->rank() > 0) {
    prepared.settings.jobs = 1;
    serve_rank(*link, prepared.cells, prepared.settings, prepared.problem);
    // Rank 0 says what is wrong. Where another rank failed first, Open MPI 5 would end them all
    // before its words are out.
    return kFine;
  }
  // Only one process opens the results.
  std::unique_ptr<ResultsFile> results;
  if (prepared.problem.empty()) {
    try {
      results = std::make_unique<ResultsFile>(plan.results, choices.results_flag);
      note_inputs(*results, plan);
    } catch (const ConfigError& error) {
      prepared.problem = error.what();
    }
  }
  if (link) greet_ranks(*link, prepared.cells, prepared.problem);
  if (!prepared.problem.empty()) throw ConfigError({}, prepared.problem);
  const bool all = run_missing(plan, choices, prepared, *results, link.get());
  results.reset();
  if (!all) return kFailed;
  show(plan, prepared.cells);
  return kFine;
}

}  // namespace eyebridge::apps
