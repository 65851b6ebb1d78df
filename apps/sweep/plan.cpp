#include "sweep/plan.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <iterator>
#include <set>

#include <fmt/format.h>

#include "eyebridge/base/text.hpp"

namespace eyebridge::apps {
namespace {

/// Which axes vary slowly, and come first in every list.
int rank_of(const Axis& axis) {
  if (axis.kind == AxisKind::Program) return 0;
  if (axis.kind == AxisKind::Setting && axis.name == "world") return 1;
  if (axis.kind == AxisKind::Setting && axis.name == "seed") return 3;
  return 2;
}

/// `text` with the values of parameters for their {names}; notes which were used.
std::string fill_in(const AxisValue& text, const std::map<std::string, std::string>& parameters,
                    std::set<std::string>& used) {
  std::string out;
  std::string_view rest = text.text;
  for (;;) {
    const std::size_t open = rest.find('{');
    const std::size_t close = rest.find('}', open);
    if (open == std::string_view::npos || close == std::string_view::npos) break;
    const std::string name(rest.substr(open + 1, close - open - 1));
    const auto found = parameters.find(name);
    if (found == parameters.end()) {
      throw ConfigError(text.where, fmt::format("found {{{}}}, expected the name of a parameter",
                                                in_quotes(name)));
    }
    out += std::string(rest.substr(0, open)) + found->second;
    used.insert(name);
    rest.remove_prefix(close + 1);
  }
  return out + std::string(rest);
}

void take(Cell& cell, const Axis& axis, const std::string& text) {
  switch (axis.kind) {
    case AxisKind::Program:
      cell.program = text;
      break;
    case AxisKind::Parameter:
      cell.parameters[axis.name] = text;
      break;
    case AxisKind::Environment:
      cell.environment[axis.name] = text;
      break;
    case AxisKind::Setting:
      cell.settings[axis.name] = text;
      break;
  }
}

void check(const SweepPlan& plan, const std::vector<Axis>& axes) {
  const auto is_program = [](const Axis& axis) { return axis.kind == AxisKind::Program; };
  if (std::ranges::none_of(axes, is_program)) {
    throw ConfigError({"sweep"},
                      "found no program, expected: eyebridge sweep [OPTIONS] PROGRAM "
                      "[ARGUMENTS], or a sweep file with program = \"...\"");
  }
  std::size_t count = 1;
  for (const Axis& axis : axes) {
    if (count > kMostCells / axis.values.size()) {
      throw ConfigError(axis.values.front().where,
                        fmt::format("found more than {} runs, expected at most that", kMostCells));
    }
    count *= axis.values.size();
  }
  std::set<std::string> used;
  std::map<std::string, std::string> parameters;
  for (const Axis& axis : axes) {
    if (axis.kind != AxisKind::Parameter) continue;
    parameters[axis.name];
    const auto same_name = [&](const Axis& other) {
      return other.kind == AxisKind::Setting && other.name == axis.name;
    };
    if (axis.name == "program" || std::ranges::any_of(axes, same_name)) {
      throw ConfigError(axis.values.front().where,
                        fmt::format("found a parameter {}, which is another axis, too; expected "
                                    "another name",
                                    in_quotes(axis.name)));
    }
  }
  for (const AxisValue& argument : plan.arguments) fill_in(argument, parameters, used);
  for (const Axis& axis : axes) {
    if (axis.kind == AxisKind::Parameter && !used.contains(axis.name)) {
      throw ConfigError(
          axis.values.front().where,
          fmt::format("the parameter {0} is not used, expected {{{1}}} in an argument",
                      in_quotes(axis.name), axis.name));
    }
  }
}

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\') out += "\\\\";
    if (c == '\n') out += "\\n";
    if (c != '\\' && c != '\n') out += c;
  }
  return out;
}

}  // namespace

Axis* SweepPlan::find(AxisKind kind, const std::string& name) {
  const auto found = std::ranges::find_if(
      axes, [&](const Axis& axis) { return axis.kind == kind && axis.name == name; });
  return found == axes.end() ? nullptr : &*found;
}

void SweepPlan::put(Axis axis) {
  if (Axis* present = find(axis.kind, axis.name)) {
    *present = std::move(axis);
  } else {
    axes.push_back(std::move(axis));
  }
}

std::vector<std::pair<std::string, std::string>> Cell::coordinates() const {
  std::vector<std::pair<std::string, std::string>> out = {{"program", program}};
  for (const auto& [name, text] : environment) out.emplace_back("$" + name, text);
  for (const auto& [name, text] : parameters) out.emplace_back(name, text);
  for (const auto& [name, text] : settings) out.emplace_back(name, text);
  return out;
}

std::string Cell::key() const {
  std::string out;
  for (const auto& [name, text] : coordinates()) {
    out += escaped(name) + "=" + escaped(text) + "\n";
  }
  for (const std::string& argument : arguments) out += escaped(argument) + "\n";
  return out;
}

std::vector<Cell> cells_of(const SweepPlan& plan) {
  std::vector<Axis> axes = plan.axes;
  std::ranges::stable_sort(axes, {}, rank_of);
  check(plan, axes);
  std::vector<Cell> cells;
  std::vector<std::size_t> at(axes.size());
  for (bool more = true; more;) {
    Cell cell;
    for (std::size_t i = 0; i < axes.size(); ++i) take(cell, axes[i], axes[i].values[at[i]].text);
    std::set<std::string> used;
    for (const AxisValue& argument : plan.arguments) {
      cell.arguments.push_back(fill_in(argument, cell.parameters, used));
    }
    cells.push_back(std::move(cell));
    more = false;
    for (std::size_t i = axes.size(); i-- > 0 && !more;) {
      more = ++at[i] < axes[i].values.size();
      if (!more) at[i] = 0;
    }
  }
  return cells;
}

std::vector<AxisValue> read_range(const std::string& text, const SourceLocation& where) {
  const auto number = [&](std::string_view digits) {
    std::int64_t value = 0;
    const char* end = digits.data() + digits.size();
    const auto [stopped, error] = std::from_chars(digits.data(), end, value);
    if (error != std::errc{} || stopped != end || value < 0) {
      throw ConfigError(where, fmt::format("found {}, expected a whole number or a range such as "
                                           "1..20",
                                           in_quotes(text)));
    }
    return value;
  };
  const std::string_view all = trimmed(text);
  const std::size_t dots = all.find("..");
  const std::int64_t first = number(trimmed(all.substr(0, dots)));
  const std::int64_t last =
      dots == std::string_view::npos ? first : number(trimmed(all.substr(dots + 2)));
  if (last < first || last - first >= static_cast<std::int64_t>(kMostCells)) {
    throw ConfigError(where, fmt::format("found {}, expected a range that goes up, of at most {}",
                                         in_quotes(text), kMostCells));
  }
  std::vector<AxisValue> out;
  for (std::int64_t i = first;; ++i) {
    out.push_back({std::to_string(i), where});
    if (i == last) return out;
  }
}

int read_jobs(const std::string& text, const SourceLocation& where) {
  int jobs = 0;
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, jobs);
  if (error != std::errc{} || stopped != end || jobs < 0 || jobs > 1024) {
    throw ConfigError(where, fmt::format("found {}, expected 0 ... 1024 runs at a time (0: one a "
                                         "core)",
                                         in_quotes(text)));
  }
  return jobs;
}

void check_can_vary(const std::string& setting, const SourceLocation& where) {
  constexpr std::string_view kOwn[] = {"report", "panel", "out", "record"};
  if (std::ranges::find(kOwn, setting) == std::end(kOwn)) return;
  throw ConfigError(where,
                    fmt::format("found {}, expected another setting: each run of a sweep has "
                                "a folder of its own",
                                in_quotes(setting)));
}

}  // namespace eyebridge::apps
