#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "assess_plan.hpp"
#include "command.hpp"
#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/own_results.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/base/write_file.hpp"
#include "sweep/assessment_output.hpp"
#include "sweep/results.hpp"
#include "sweep_runs.hpp"

namespace eyebridge::apps {
namespace {

namespace fs = std::filesystem;

/// True for a folder that was not there.
bool make_folder(const std::string& out) {
  std::error_code error;
  const bool is_new = fs::create_directories(out, error);
  if (!error && fs::is_directory(out, error)) return is_new;
  throw ConfigError({"--out"}, fmt::format("cannot make the folder {}: {}", out,
                                           error ? error.message() : "it is a file"));
}

void write_text(const fs::path& file, const std::string& text) {
  drop_link(file);
  check_replaceable(file, "table", text.substr(0, text.find(',')));  // the first heading
  if (const auto done = write_file(file, text); !done) {
    throw std::runtime_error(file.string() + ": " + done.error().what);
  }
}

void show_assessment(const Assessment& assessment, const fs::path& out, const SweepPlan& plan,
                     const std::vector<Cell>& cells) {
  const std::vector<AssessedRun> runs =
      assess_runs(read_results_file(plan.results), cells, assessment.criteria(plan));
  const std::vector<Score> scores = score(runs);
  std::fputs(printable(assessment_table(scores)).c_str(), stdout);
  write_text(out / "runs.csv", runs_csv(runs));
  write_text(out / "summary.csv", summary_csv(scores));
  plot_assessment(scores, out);
}

}  // namespace

void add_assess(CLI::App& root, int& code) {
  CLI::App* command = root.add_subcommand(
      "assess",
      "How well a controller does over worlds and seeds: assess [OPTIONS] CONTROLLER [ARGUMENTS]");
  command->footer(
      "CONTROLLER is a control file (def run(robot, keep_going, ...)) or any robot program. Every\n"
      "setting of eyebridge run is an option; a run that has not ended after --time-limit [60s]\n"
      "fails. The folder --out gets runs.csv, summary.csv and pictures; the same command again\n"
      "runs only what is missing. See docs/assess.md.");
  command->prefix_command();
  const auto flags = std::make_shared<AssessFlags>();
  const auto choices = std::make_shared<RunChoices>();
  choices->results_flag = "--out";
  add_axis_flags(*command, flags->sweep, {"world", "seed", "out"});
  const auto add_list = [&](const char* name, std::vector<std::string>& list, const char* help,
                            const char* type) {
    command->add_option(name, list, help)
        ->type_name(type)
        ->expected(1)
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  };
  add_list("--worlds", flags->worlds, "The worlds, with commas between", "WORLD,...");
  add_list("--goal", flags->goals,
           "Where robot 1 must be at the end, mm; none: anywhere; several times with a world each",
           "[WORLD:]X,Y,RADIUS");
  command->add_option("--seeds", flags->seeds, "How many (20: 1..20), or a range")
      ->capture_default_str()
      ->type_name("N|A..B");
  command->add_flag("--no-collisions", flags->no_collisions,
                    "A run in which a robot hits something fails");
  command->add_option("--out", flags->out, "Folder for tables and pictures")
      ->capture_default_str()
      ->type_name("FOLDER");
  command->add_flag("--retry", choices->retry, "Runs what went wrong again, too");
  command->add_flag("--keep", choices->keep, "Keeps the files of all runs");
  command->callback([command, flags, choices, &code] {
    Assessment assessment = make_assessment(*flags, command->remaining());
    const bool is_new = make_folder(flags->out);
    const auto shown = [&](const SweepPlan& plan, const std::vector<Cell>& cells) {
      show_assessment(assessment, flags->out, plan, cells);
    };
    try {
      code = run_plan(assessment.plan, *choices, shown);
    } catch (const ConfigError&) {
      std::error_code in_use;  // by what was run before
      if (is_new) fs::remove(flags->out, in_use);
      throw;
    }
  });
}

}  // namespace eyebridge::apps
