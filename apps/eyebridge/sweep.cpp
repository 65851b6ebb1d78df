#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>

#include "command.hpp"
#include "eyebridge/base/text.hpp"
#include "sweep/plot.hpp"
#include "sweep/results.hpp"
#include "sweep/summary.hpp"
#include "sweep_plan.hpp"
#include "sweep_runs.hpp"

namespace eyebridge::apps {
namespace {

struct ShowFlags {
  std::vector<std::string> by;
  std::string plot;
  std::string value = "time";
  bool only_show = false;
  RunChoices runs;
};

void show(const std::string& results, const ShowFlags& flags) {
  const std::vector<Group> groups = group_runs(read_results_file(results), flags.by);
  std::fputs(printable(summary_table(groups)).c_str(), stdout);
  if (!flags.plot.empty()) plot(groups, flags.value, flags.plot);
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
  add_axis_flags(*command, *plan);
  command->add_option("--results", plan->results, "The results, an SQLite file [sweep.db]")
      ->type_name("FILE");
  command->add_flag("--show", flags->only_show, "Runs nothing: shows what the results hold");
  command->add_flag("--retry", flags->runs.retry, "Runs what went wrong again, too");
  command->add_flag("--keep", flags->runs.keep, "Keeps the files of all runs in RESULTS.runs");
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
      const auto shown = [&](const SweepPlan& run, const std::vector<Cell>&) {
        show(run.results, *flags);
      };
      code = run_plan(std::move(made), flags->runs, shown);
    }
  });
}

}  // namespace eyebridge::apps
