#include <chrono>
#include <cstdio>
#include <memory>
#include <system_error>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include "command.hpp"
#include "eyebridge/base/config_error.hpp"
#include "own_files.hpp"
#include "stop_signals.hpp"
#include "sweep/plot.hpp"
#include "sweep/progress.hpp"
#include "sweep/ranks.hpp"
#include "sweep/results.hpp"
#include "sweep/summary.hpp"
#include "sweep_plan.hpp"

namespace eyebridge::apps {
namespace {

struct ShowFlags {
  std::vector<std::string> by;
  std::string plot;
  std::string value = "time";
  bool only_show = false;
  bool retry = false;
  bool keep = false;
};

void show(const std::string& results, const ShowFlags& flags) {
  const std::vector<Group> groups = group_runs(read_results_file(results), flags.by);
  std::fputs(summary_table(groups).c_str(), stdout);
  if (!flags.plot.empty()) plot(groups, flags.value, flags.plot);
}

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

Prepared prepare_all(SweepPlan& plan, const ShowFlags& flags) {
  Prepared out;
  try {
    out.settings = prepare(plan);
    out.settings.keep_files = flags.keep;
    out.cells = cells_of(plan);
  } catch (const ConfigError& error) {
    out.problem = error.what();
  }
  return out;
}

/// Runs what is missing, here or on the other ranks of `link`.
int run_missing(const SweepPlan& plan, const ShowFlags& flags, const Prepared& prepared,
                ResultsFile& results, RankLink* link) {
  const std::vector<Cell>& cells = prepared.cells;
  const std::vector<std::size_t> todo = missing(cells, results.keys(flags.retry));
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
  if (all) return kFine;
  fmt::print(stderr, "eyebridge: interrupted with {} of {} runs in {}; the same command goes on\n",
             cells.size() - todo.size() + done, cells.size(), plan.results);
  return kFailed;
}

int sweep(SweepPlan plan, const ShowFlags& flags) {
  std::unique_ptr<RankLink> link =
      open_rank_link((own_files().library.parent_path() / "libeyebridge_mpi.so").string());
  if (link && link->size() == 1) link.reset();
  Prepared prepared = prepare_all(plan, flags);
  stop_on_signals();
  if (link && link->rank() > 0) {
    prepared.settings.jobs = 1;
    serve_rank(*link, prepared.cells, prepared.settings, prepared.problem);
    return prepared.problem.empty() ? kFine : kBadInput;
  }
  // Only one process opens the results.
  std::unique_ptr<ResultsFile> results;
  if (prepared.problem.empty()) {
    try {
      results = std::make_unique<ResultsFile>(plan.results);
      note_inputs(*results, plan);
    } catch (const ConfigError& error) {
      prepared.problem = error.what();
    }
  }
  if (link) greet_ranks(*link, prepared.cells, prepared.problem);
  if (!prepared.problem.empty()) throw ConfigError({}, prepared.problem);
  const int code = run_missing(plan, flags, prepared, *results, link.get());
  results.reset();
  if (code == kFine) show(plan.results, flags);
  return code;
}

}  // namespace

void add_sweep(CLI::App& root, int& code) {
  CLI::App* command = root.add_subcommand(
      "sweep",
      "Runs programs for all seeds, worlds, parameters: sweep [OPTIONS] PROGRAM|FILE.toml");
  command->footer(
      "Every setting of eyebridge run is an option, and may be given several times: all "
      "combinations\n"
      "are run, in virtual time. --seed takes ranges: 1..20. What ends is kept in --results at "
      "once;\n"
      "the same command again runs only what is missing. See docs/training.md.");
  command->prefix_command();
  const auto plan = std::make_shared<SweepFlags>();
  const auto flags = std::make_shared<ShowFlags>();
  add_sweep_flags(*command, *plan);
  command->add_flag("--show", flags->only_show, "Runs nothing: shows what the results hold");
  command->add_flag("--retry", flags->retry, "Runs what went wrong again, too");
  command->add_flag("--keep", flags->keep, "Keeps the files of all runs in RESULTS.runs");
  command->add_option("--by", flags->by, "Groups of the table: names of what varies [all but seed]")
      ->type_name("NAME")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  CLI::Option* plotted = command->add_option("--plot", flags->plot, "Draws a picture of --value")
                             ->type_name("FILE.png");
  command->add_option("--value", flags->value, "Of --plot: time, distance, collisions or a result")
      ->capture_default_str()
      ->needs(plotted)
      ->type_name("NAME");
  command->callback([command, plan, flags, &code] {
    SweepPlan made = make_plan(*plan, command->remaining());
    if (flags->only_show) {
      show(made.results, *flags);
      code = kFine;
    } else {
      code = sweep(std::move(made), *flags);
    }
  });
}

}  // namespace eyebridge::apps
