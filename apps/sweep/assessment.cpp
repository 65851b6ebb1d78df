#include "sweep/assessment.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <filesystem>
#include <set>

#include <fmt/format.h>

namespace eyebridge::apps {
namespace {

/// Worlds by their file's name; by their whole path where two have one name.
class WorldNames {
 public:
  explicit WorldNames(const std::vector<Cell>& cells) {
    for (const Cell& cell : cells) {
      const auto world = cell.settings.find("world");
      if (world != cell.settings.end()) paths_[name_of(world->second)].insert(world->second);
    }
  }
  [[nodiscard]] std::string operator()(const std::string& world) const {
    const std::string name = name_of(world);
    return paths_.at(name).size() == 1 ? name : world;
  }

 private:
  static std::string name_of(const std::string& path) {
    return std::filesystem::path(path).filename().string();
  }
  std::map<std::string, std::set<std::string>> paths_;
};

/// Coordinates of more than one value, but for the world, which comes first in every label, and
/// the seed.
std::vector<std::string> varied_coordinates(const std::vector<Cell>& cells) {
  std::map<std::string, std::set<std::string>> seen;
  for (const Cell& cell : cells) {
    for (const auto& [name, value] : cell.coordinates()) seen[name].insert(value);
  }
  std::vector<std::string> out;
  for (const auto& [name, values] : seen) {
    if (values.size() > 1 && name != "world" && name != "seed") out.push_back(name);
  }
  return out;
}

void count_against(AssessedRun& run, const std::string& verdict, const std::string& reason) {
  if (run.success()) run.verdict = verdict;
  run.reason += (run.reason.empty() ? "" : "; ") + reason;
}

void judge_goal(AssessedRun& run, const Goal& goal) {
  const auto x = run.row.values.find("end_x");
  const auto y = run.row.values.find("end_y");
  if (x == run.row.values.end() || y == run.row.values.end()) {
    count_against(run, "no robot", "no robot was used");
    return;
  }
  run.goal_distance = norm(Vec2{x->second, y->second} - goal.centre);
  if (*run.goal_distance <= goal.radius) return;
  count_against(run, "goal missed",
                fmt::format("ended {:.3f} m from the goal's centre", *run.goal_distance));
}

void judge_collisions(AssessedRun& run) {
  const auto found = run.row.values.find("collisions");
  if (found == run.row.values.end()) {
    count_against(run, "no robot", "no robot was used");
  } else if (found->second > 0) {
    count_against(run, "collision",
                  fmt::format("{:g} collision{}", found->second, found->second == 1 ? "" : "s"));
  }
}

void judge(AssessedRun& run, const Criteria& criteria) {
  run.verdict = "success";
  if (run.row.how != "ended") {
    count_against(run, run.row.how,
                  run.row.reason.empty() ? "no end before the time limit" : run.row.reason);
  }
  const auto world = run.row.coordinates.find("world");
  const Goal* goal = criteria.goal_in(world == run.row.coordinates.end() ? "" : world->second);
  if (goal != nullptr) judge_goal(run, *goal);
  if (criteria.no_collisions) judge_collisions(run);
}

void add_to(Score& score, const AssessedRun& run) {
  ++score.runs;
  ++(run.success() ? score.successes : score.failures[run.verdict]);
  for (const Measure& measure : measures()) {
    const auto found = run.row.values.find(measure.value);
    if (found == run.row.values.end() || (measure.of_successes && !run.success())) continue;
    score.values[measure.value].push_back(found->second);
  }
}

}  // namespace

const Goal* Criteria::goal_in(const std::string& world) const {
  const auto own = goals.find(world);
  if (own != goals.end()) return &own->second;
  return goal ? &*goal : nullptr;
}

std::vector<AssessedRun> assess_runs(const std::vector<ResultRow>& rows,
                                     const std::vector<Cell>& cells, const Criteria& criteria) {
  std::map<std::string, const ResultRow*> by_key;
  for (const ResultRow& row : rows) by_key[row.key] = &row;
  const WorldNames world_name(cells);
  const std::vector<std::string> varied = varied_coordinates(cells);
  std::vector<AssessedRun> out;
  for (const Cell& cell : cells) {
    const auto found = by_key.find(cell.key());
    if (found == by_key.end()) continue;
    AssessedRun& run = out.emplace_back();
    run.row = *found->second;
    const auto world = cell.settings.find("world");
    if (world != cell.settings.end()) run.group = world_name(world->second);
    for (const std::string& name : varied) {
      run.group += (run.group.empty() ? "" : " ") + name + "=" + run.row.coordinates.at(name);
    }
    judge(run, criteria);
  }
  return out;
}

Interval wilson_interval(std::size_t successes, std::size_t runs) {
  assert(runs > 0 && successes <= runs);
  constexpr double kZ = 1.959963984540054;  // 97.5 % of a normal distribution lie below it
  const auto n = static_cast<double>(runs);
  const double rate = static_cast<double>(successes) / n;
  const double scale = 1 + kZ * kZ / n;
  const double centre = (rate + kZ * kZ / (2 * n)) / scale;
  const double half = kZ / scale * std::sqrt(rate * (1 - rate) / n + kZ * kZ / (4 * n * n));
  // None and all reach 0 and 1, which rounding would miss by a bit.
  return {successes == 0 ? 0.0 : centre - half, successes == runs ? 1.0 : centre + half};
}

double quantile(std::vector<double> values, double share) {
  assert(!values.empty() && share >= 0 && share <= 1);
  std::ranges::sort(values);
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - std::floor(place)) * (values[above] - values[below]);
}

const std::vector<Measure>& measures() {
  static const std::vector<Measure> all = {
      {"time", "time, s", "time_s", true},
      {"distance", "path length, m", "path_m", true},
      {"collisions", "collisions", "collisions", false},
      {"coverage", "coverage", "coverage", false},
      {"agreement", "map agreement", "agreement", false},
  };
  return all;
}

double Score::rate() const {
  return runs == 0 ? 0.0 : static_cast<double>(successes) / static_cast<double>(runs);
}

std::vector<Score> score(const std::vector<AssessedRun>& runs) {
  std::vector<Score> out;
  std::map<std::string, std::size_t> places;
  std::map<std::string, std::set<std::string>> hashes;
  Score all{"all", 0, 0, {}, {}, false};
  for (const AssessedRun& run : runs) {
    const auto [place, is_new] = places.emplace(run.group, out.size());
    if (is_new) out.push_back({run.group, 0, 0, {}, {}, false});
    add_to(out[place->second], run);
    add_to(all, run);
    hashes[run.group].insert(run.row.state_hash);
  }
  for (Score& each : out) {
    const std::set<std::string>& seen = hashes.at(each.group);
    each.all_alike = each.runs > 1 && seen.size() == 1 && !seen.begin()->empty();
  }
  if (out.size() > 1) out.push_back(std::move(all));
  return out;
}

}  // namespace eyebridge::apps
