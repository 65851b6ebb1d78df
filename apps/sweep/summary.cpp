#include "sweep/summary.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/text.hpp"

namespace eyebridge::apps {
namespace {

/// Coordinates by which runs are told apart: all that have more than one value, but for the seed.
std::vector<std::string> differing(const std::vector<ResultRow>& rows) {
  std::map<std::string, std::set<std::string>> seen;
  std::map<std::string, std::size_t> counts;
  for (const ResultRow& row : rows) {
    for (const auto& [name, value] : row.coordinates) {
      seen[name].insert(value);
      ++counts[name];
    }
  }
  std::vector<std::string> out;
  for (const auto& [name, values] : seen) {
    const bool differs = values.size() > 1 || counts[name] != rows.size();
    if (name != "seed" && differs) out.push_back(name);
  }
  return out;
}

void check_known(const std::vector<ResultRow>& rows, const std::vector<std::string>& by) {
  for (const std::string& name : by) {
    const auto has = [&](const ResultRow& row) { return row.coordinates.contains(name); };
    if (std::ranges::any_of(rows, has)) continue;
    std::string known;
    if (!rows.empty()) {
      for (const auto& [other, value] : rows.front().coordinates) known += " " + other;
    }
    throw ConfigError({"--by"},
                      fmt::format("found {}, expected one of:{}", in_quotes(name), known));
  }
}

std::string label_of(const ResultRow& row, const std::vector<std::string>& by) {
  std::string label;
  for (const std::string& name : by) {
    const auto found = row.coordinates.find(name);
    std::string value = found == row.coordinates.end() ? "-" : found->second;
    // Of paths the last part tells them apart, and is what people call them.
    if (name == "program" || name == "world") value = value.substr(value.rfind('/') + 1);
    label += (label.empty() ? "" : " ") + name + "=" + value;
  }
  return label.empty() ? "all runs" : label;
}

bool ended_well(const ResultRow& row) { return row.how == "ended" || row.how == "time limit"; }

}  // namespace

void Spread::add(double value) {
  least = count == 0 ? value : std::min(least, value);
  most = count == 0 ? value : std::max(most, value);
  ++count;
  const double before = value - mean;
  mean += before / static_cast<double>(count);
  squares_ += before * (value - mean);
  deviation = count > 1 ? std::sqrt(squares_ / static_cast<double>(count - 1)) : 0.0;
}

Spread Group::spread(const std::string& value) const {
  Spread out;
  const auto found = values.find(value);
  if (found == values.end()) return out;
  for (const double number : found->second) out.add(number);
  return out;
}

std::vector<Group> group_runs(const std::vector<ResultRow>& rows,
                              const std::vector<std::string>& by) {
  check_known(rows, by);
  const std::vector<std::string> names = by.empty() ? differing(rows) : by;
  std::vector<Group> groups;
  std::map<std::string, std::size_t> places;
  for (const ResultRow& row : rows) {
    const std::string label = label_of(row, names);
    const auto [place, is_new] = places.emplace(label, groups.size());
    if (is_new) groups.push_back({label, 0, {}, {}});
    Group& group = groups[place->second];
    ++group.runs;
    ++group.ends[row.how];
    if (!ended_well(row)) continue;
    for (const auto& [name, value] : row.values) group.values[name].push_back(value);
  }
  // Runs end in any order; a table is to be the same every time.
  std::ranges::stable_sort(groups, {}, &Group::label);
  return groups;
}

std::string summary_table(const std::vector<Group>& groups) {
  std::string out;
  for (const Group& group : groups) {
    out += fmt::format("{}: {} run{}", group.label, group.runs, group.runs == 1 ? "" : "s");
    for (const auto& [how, count] : group.ends) out += fmt::format(", {} {}", count, how);
    out += "\n";
    if (!group.values.empty()) {
      out += fmt::format("  {:<16} {:>12} {:>12} {:>12} {:>12}\n", "", "mean", "deviation", "least",
                         "most");
    }
    for (const auto& [name, values] : group.values) {
      const Spread s = group.spread(name);
      out += fmt::format("  {:<16} {:>12.5g} {:>12.5g} {:>12.5g} {:>12.5g}\n", name, s.mean,
                         s.deviation, s.least, s.most);
    }
  }
  return out;
}

}  // namespace eyebridge::apps
