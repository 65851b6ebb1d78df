#include "sweep_plan.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <set>
#include <thread>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <sched.h>

#include "check_settings.hpp"
#include "config/toml_text.hpp"
#include "eyebridge/base/one_line.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/base/trust.hpp"
#include "eyebridge/hal/config.hpp"
#include "eyebridge/hal/world_file.hpp"
#include "program.hpp"
#include "setting_flags.hpp"
#include "sweep/sweep_file.hpp"

namespace eyebridge::apps {
namespace {

namespace fs = std::filesystem;

/// Adds `value` to the axis of a flag that may be given several times; the first of them takes the
/// place of what the file said.
void add_value(SweepPlan& plan, std::set<std::string>& begun, AxisKind kind,
               const std::string& name, std::vector<AxisValue> values) {
  Axis* axis = plan.find(kind, name);
  if (axis == nullptr || begun.insert(std::to_string(static_cast<int>(kind)) + name).second) {
    plan.put({kind, name, std::move(values)});
    begun.insert(std::to_string(static_cast<int>(kind)) + name);
  } else {
    axis->values.insert(axis->values.end(), values.begin(), values.end());
  }
}

void add_pair(SweepPlan& plan, std::set<std::string>& begun, AxisKind kind, const char* flag,
              const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw ConfigError({flag}, fmt::format("found {}, expected NAME=VALUE", in_quotes(text)));
  }
  const std::string name = text.substr(0, equals);
  if (kind == AxisKind::Environment && name.starts_with("EYEBRIDGE_")) {
    throw ConfigError({flag}, fmt::format("found {}, expected the setting itself", name));
  }
  add_value(plan, begun, kind, name, {{text.substr(equals + 1), {flag}}});
}

/// One core of those that this process may use.
int core_count() {
  cpu_set_t cores;
  if (sched_getaffinity(0, sizeof cores, &cores) == 0) return CPU_COUNT(&cores);
  return static_cast<int>(std::max(std::thread::hardware_concurrency(), 1U));
}

void check_trust(const SweepPlan& plan) {
  for (const Asked& asked : asked_by(plan)) {
    if (Trust::of_user().covers(asked.where.file, asked.text)) continue;
    throw ConfigError(
        asked.where, fmt::format("found {}, which starts a program outside of this file's folder{}",
                                 printable(asked.text), how_to_trust(asked.where.file)));
  }
}

/// Runs have working folders of their own: what lies here is named from the root.
std::string from_the_root(const std::string& path) {
  std::error_code ignored;
  return fs::exists(path, ignored) ? fs::absolute(path).lexically_normal().string() : path;
}

/// A program in the folder of all programs; empty where they lie in several: then each run looks
/// for worlds beside its own.
std::string program_of_all(SweepPlan& plan) {
  const Axis* programs = plan.find(AxisKind::Program, "program");
  if (programs == nullptr || programs->values.empty()) return "";
  const std::string& first = programs->values.front().text;
  const auto is_beside = [&](const AxisValue& other) {
    return fs::path(other.text).parent_path() == fs::path(first).parent_path();
  };
  return std::ranges::all_of(programs->values, is_beside) ? first : "";
}

void make_paths_absolute(SweepPlan& plan) {
  const std::string program = program_of_all(plan);
  for (Axis& axis : plan.axes) {
    if (axis.kind != AxisKind::Setting) continue;
    if (hal::find_setting(axis.name)->kind != hal::Setting::Kind::Path) continue;
    for (AxisValue& value : axis.values) {
      if (axis.name == "world" && !value.text.empty())
        value.text = hal::world_file({value.text, value.where}, program);
      value.text = from_the_root(value.text);
    }
  }
}

/// Settings of the eyebridge.toml in this folder, which the runs do not see, and --fast.
std::map<std::string, std::string> settings_from_here() {
  std::map<std::string, std::string> out;
  const hal::Config config = hal::Config::from_command_line({}, {});
  for (const hal::Setting& setting : hal::settings()) {
    const hal::ConfigValue& value = config.value(setting.key);
    if (value.where.file != "eyebridge.toml") continue;
    out[std::string(setting.key)] =
        setting.kind == hal::Setting::Kind::Path ? from_the_root(value.text) : value.text;
  }
  if (config.value("fast").is_default()) out["fast"] = "true";
  for (const char* of_one_run : {"out", "record"}) out.erase(of_one_run);
  return out;
}

/// `error`, where the axis was written whose value it is about.
[[noreturn]] void rethrow_in_place(const SweepPlan& plan, const Cell& cell,
                                   const ConfigError& error) {
  for (const Axis& axis : plan.axes) {
    if (axis.kind != AxisKind::Setting) continue;
    const std::string& text = cell.settings.at(axis.name);
    const bool meant = error.where().file == hal::Config::flag_name(axis.name) ||
                       (!text.empty() && error.where().file == text);
    const auto written = std::ranges::find(axis.values, text, &AxisValue::text);
    if (!meant || written->where.line == 0) continue;
    const bool same = error.where().file == hal::Config::flag_name(axis.name);
    throw ConfigError(written->where, same ? error.text() : error.what());
  }
  throw error;
}

void check_all_settings(const SweepPlan& plan, const RunSettings& settings) {
  std::set<std::pair<std::string, SettingFlags>> checked;
  for (const Cell& cell : cells_of(plan)) {
    SettingFlags flags = settings.base;
    for (const auto& [key, text] : cell.settings) flags[key] = text;
    // Of all seeds one tells enough.
    SettingFlags distinct = flags;
    distinct.erase("seed");
    if (!checked.emplace(cell.program, std::move(distinct)).second) continue;
    try {
      check_settings(hal::Config::from_command_line(cell.program, flags));
    } catch (const ConfigError& error) {
      rethrow_in_place(plan, cell, error);
    }
  }
}

}  // namespace

void add_axis_flags(CLI::App& command, SweepFlags& flags, const std::set<std::string>& except) {
  for (const hal::Setting& setting : hal::settings()) {
    const std::string key(setting.key);
    if (except.contains(key)) continue;
    const auto store = [&flags, key](const CLI::results_t& values) {
      for (const std::string& value : values) {
        flags.settings.emplace_back(key, value.empty() ? "true" : value);
      }
      return true;
    };
    CLI::Option* option =
        command.add_option(hal::Config::flag_name(key), store, std::string(setting.help));
    option->type_name(setting_type(setting))->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    if (setting.kind == hal::Setting::Kind::Boolean) {
      option->type_size(0)->expected(0, 1);
    } else {
      option->type_size(1)->expected(1)->allow_extra_args(false);
    }
  }
  command.add_option("--env", flags.environment, "A variable of the program's environment")
      ->type_name("NAME=VALUE")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_option("--parameter", flags.parameters, "A value for {NAME} among the arguments")
      ->type_name("NAME=VALUE")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_option("--wall-limit", flags.wall_limit, "A run that takes longer hangs [10min]")
      ->type_name("TIME");
  command.add_option("--jobs", flags.jobs, "Runs at a time [one a core]")->type_name("N");
}

void find_programs(SweepPlan& plan) {
  Axis* programs = plan.find(AxisKind::Program, "program");
  if (programs == nullptr) return;  // cells_of() says so
  for (AxisValue& value : programs->values) {
    try {
      value.text = fs::absolute(find_program(value.text)).string();
    } catch (const ConfigError& error) {
      if (value.where.line == 0) throw;
      throw ConfigError(value.where, error.where().file + ": " + error.text());
    }
  }
}

namespace {

/// All that the file hands to the programs that it starts: " \"-c\" NAME=\"a\",\"b\"".
std::string handed_over(const SweepPlan& plan) {
  std::string text;
  for (const AxisValue& word : plan.arguments) {
    if (word.where.line > 0) text += ' ' + as_one_word(word.text);
  }
  for (const Axis& axis : plan.axes) {
    if (axis.kind != AxisKind::Parameter && axis.kind != AxisKind::Environment) continue;
    std::string values;
    for (const AxisValue& value : axis.values) {
      if (value.where.line > 0) values += (values.empty() ? "" : ",") + as_one_word(value.text);
    }
    if (!values.empty()) text += ' ' + escaped(axis.name) + '=' + values;
  }
  return text;
}

}  // namespace

std::vector<Asked> asked_by(const SweepPlan& plan) {
  std::vector<Asked> out;
  for (const Axis& axis : plan.axes) {
    const bool is_program = axis.kind == AxisKind::Program;
    const hal::Setting* const setting =
        axis.kind == AxisKind::Setting ? hal::find_setting(axis.name) : nullptr;
    for (const AxisValue& value : axis.values) {
      if (value.where.line == 0) continue;  // a flag
      if (is_program && !is_within(value.text, fs::path(value.where.file).parent_path())) {
        std::error_code error;
        const fs::path file = fs::canonical(value.text, error);
        out.push_back(
            {"program = " + as_one_word(error ? value.text : file.string()) + handed_over(plan),
             value.where});
      }
      if (setting != nullptr && hal::has_effect(*setting, value.text)) {
        out.push_back({hal::asked_by(*setting, value.text), value.where});
      }
    }
  }
  return out;
}

SweepPlan make_plan(const SweepFlags& flags, const std::vector<std::string>& words) {
  SweepPlan plan;
  const bool from_file = !words.empty() && fs::path(words.front()).extension() == ".toml";
  if (from_file) {
    const std::optional<std::string> text = hal::read_toml_file(words.front());
    if (!text) throw ConfigError({words.front()}, "no such sweep file");
    plan = read_sweep(*text, words.front());
    if (words.size() > 1) {
      throw ConfigError({words[1]}, "found it after the sweep file, expected options before it");
    }
  } else if (!words.empty()) {
    if (words.front().starts_with('-')) {
      throw ConfigError({words.front()},
                        "unknown option; eyebridge sweep --help lists those there are");
    }
    plan.put({AxisKind::Program, "program", {{words.front(), {"program"}}}});
    for (const std::string& word : std::vector(words.begin() + 1, words.end())) {
      plan.arguments.push_back({word, {word}});
    }
  }
  std::set<std::string> begun;
  for (const auto& [key, text] : flags.settings) {
    const SourceLocation where{hal::Config::flag_name(key)};
    check_can_vary(key, where);
    std::vector<AxisValue> values = {{text, where}};
    if (key == "seed") values = read_range(text, where);
    add_value(plan, begun, AxisKind::Setting, key, std::move(values));
  }
  for (const std::string& text : flags.environment) {
    add_pair(plan, begun, AxisKind::Environment, "--env", text);
  }
  for (const std::string& text : flags.parameters) {
    add_pair(plan, begun, AxisKind::Parameter, "--parameter", text);
  }
  if (!flags.results.empty()) plan.results = flags.results;
  if (!flags.wall_limit.empty()) {
    plan.wall_limit = parse_duration(flags.wall_limit, {"--wall-limit"});
  }
  if (!flags.jobs.empty()) plan.jobs = read_jobs(flags.jobs, {"--jobs"});
  return plan;
}

RunSettings prepare(SweepPlan& plan) {
  find_programs(plan);
  check_trust(plan);
  make_paths_absolute(plan);
  RunSettings settings;
  settings.command = fs::read_symlink("/proc/self/exe");
  settings.folder = fs::absolute(plan.results + ".runs");
  // What is in it is removed.
  if (fs::is_symlink(settings.folder)) {
    throw ConfigError({settings.folder.string()},
                      "found a symbolic link, expected a folder or nothing: remove it");
  }
  settings.base = settings_from_here();
  settings.wall_limit = plan.wall_limit;
  settings.jobs = plan.jobs > 0 ? plan.jobs : core_count();
  check_all_settings(plan, settings);
  return settings;
}

}  // namespace eyebridge::apps
