#include "assess_plan.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/files/load.hpp"
#include "eyebridge/files/search.hpp"
#include "eyebridge/hal/config.hpp"

namespace eyebridge::apps {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDefaultTimeLimit = "60s";

std::vector<std::string> split_at(char separator, std::string_view text) {
  std::vector<std::string> out;
  for (;;) {
    const std::size_t end = text.find(separator);
    out.emplace_back(trimmed(text.substr(0, end)));
    if (end == std::string_view::npos) return out;
    text.remove_prefix(end + 1);
  }
}

std::vector<AxisValue> worlds_of(const AssessFlags& flags, const std::string& controller) {
  std::vector<AxisValue> out;
  const auto places = files::SearchPlaces::of_process(controller);
  for (const std::string& text : flags.worlds) {
    for (const std::string& name : split_at(',', text)) {
      if (name.empty()) {
        throw ConfigError({"--worlds"}, fmt::format("found {}, expected files with commas between",
                                                    in_quotes(text)));
      }
      std::string world = files::find_file(name, {}, places, {"--worlds"}).string();
      const auto same = [&](const AxisValue& other) {
        return fs::absolute(other.text).lexically_normal() ==
               fs::absolute(world).lexically_normal();
      };
      if (std::ranges::any_of(out, same)) {
        throw ConfigError({"--worlds"}, fmt::format("found {} twice, expected each world once",
                                                    in_quotes(world)));
      }
      out.push_back({std::move(world), {"--worlds"}});
    }
  }
  if (out.empty()) {
    throw ConfigError({"--worlds"},
                      "found none, expected files with commas between, before the controller");
  }
  return out;
}

/// "20" is 1..20.
std::vector<AxisValue> seeds_of(const std::string& text) {
  const SourceLocation where{"--seeds"};
  if (text.find("..") != std::string::npos) return read_range(text, where);
  const std::string count = read_range(text, where).front().text;
  if (count == "0") throw ConfigError(where, "found 0, expected how many (1 or more), or a range");
  return read_range("1.." + count, where);
}

/// "X,Y,RADIUS" in millimetres.
Goal read_goal(const std::string& text, const std::string& all) {
  std::vector<double> numbers;
  for (const std::string& part : split_at(',', text)) {
    double number = 0;
    const char* end = part.data() + part.size();
    const auto [stopped, error] = std::from_chars(part.data(), end, number);
    if (error == std::errc{} && stopped == end && std::isfinite(number)) numbers.push_back(number);
  }
  if (numbers.size() != 3 || std::ranges::count(text, ',') != 2 || numbers[2] <= 0) {
    throw ConfigError({"--goal"}, fmt::format("found {}, expected X,Y,RADIUS in mm, a radius of "
                                              "more than 0 (WORLD:X,Y,RADIUS for one world), or "
                                              "none",
                                              in_quotes(all)));
  }
  return {{mm_to_m(numbers[0]), mm_to_m(numbers[1])}, mm_to_m(numbers[2])};
}

/// Index of the world that a goal names, as --worlds does or by its file's name.
std::size_t world_named(const std::string& name, const std::vector<AxisValue>& worlds) {
  std::string known;
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < worlds.size(); ++i) {
    if (worlds[i].text == name) return i;
    if (fs::path(worlds[i].text).filename() == name) found.push_back(i);
    known += " " + worlds[i].text;
  }
  if (found.size() == 1) return found.front();
  throw ConfigError({"--goal"},
                    fmt::format("found {}world {}, expected one of --worlds:{}",
                                found.empty() ? "" : "more than one ", in_quotes(name), known));
}

/// Throws where a robot could never be: what is meant is another world, or another unit.
void check_in_world(const Goal& goal, const std::string& path, const std::string& robot) {
  const files::Scenario scenario = files::load_scenario(path, {.robot = robot});
  const Vec2 near = scenario.world.corner;
  const Vec2 far = scenario.world.far_corner();
  const Vec2 at = goal.centre;
  if (scenario.world.has_floor_at(at)) return;
  throw ConfigError(
      {"--goal"},
      fmt::format("found ({:g}, {:g}) mm, expected a place in {}: {:g} ... {:g} by {:g} "
                  "... {:g} mm",
                  m_to_mm(at.x), m_to_mm(at.y), path, m_to_mm(near.x), m_to_mm(far.x),
                  m_to_mm(near.y), m_to_mm(far.y)));
}

void read_goals(Assessment& out, const AssessFlags& flags, const std::vector<AxisValue>& worlds,
                const std::string& robot) {
  for (const std::string& text : flags.goals) {
    if (text == "none") {
      if (flags.goals.size() == 1) return;
      throw ConfigError({"--goal"}, "found none beside other goals, expected it alone");
    }
    const std::size_t colon = text.rfind(':');
    const bool is_of_all = colon == std::string::npos;
    const Goal goal = read_goal(is_of_all ? text : text.substr(colon + 1), text);
    const bool is_new =
        is_of_all ? !out.goal
                  : out.goals.emplace(world_named(text.substr(0, colon), worlds), goal).second;
    if (!is_new) {
      throw ConfigError({"--goal"}, fmt::format("found {} as a second goal, expected one a world",
                                                in_quotes(text)));
    }
    if (is_of_all) out.goal = goal;
  }
  for (std::size_t i = 0; i < worlds.size(); ++i) {
    const auto own = out.goals.find(i);
    if (own != out.goals.end()) {
      check_in_world(own->second, worlds[i].text, robot);
    } else if (out.goal) {
      check_in_world(*out.goal, worlds[i].text, robot);
    }
  }
}

void check_controller(const std::vector<std::string>& words) {
  if (words.empty()) {
    throw ConfigError({"assess"},
                      "found no controller, expected: eyebridge assess [OPTIONS] CONTROLLER "
                      "[ARGUMENTS]");
  }
  if (words.front().starts_with('-')) {
    throw ConfigError({words.front()},
                      "unknown option; eyebridge assess --help lists those there are");
  }
  if (fs::path(words.front()).extension() == ".toml") {
    throw ConfigError({words.front()},
                      "found a sweep file, expected a control file or a robot program");
  }
}

bool is_given(const AssessFlags& flags, const char* key) {
  return std::ranges::any_of(flags.sweep.settings,
                             [&](const auto& setting) { return setting.first == key; });
}

}  // namespace

Criteria Assessment::criteria(const SweepPlan& run) const {
  Criteria out{no_collisions, goal, {}};
  for (const Axis& axis : run.axes) {
    if (axis.kind != AxisKind::Setting || axis.name != "world") continue;
    for (const auto& [index, own] : goals) out.goals[axis.values.at(index).text] = own;
  }
  return out;
}

Assessment make_assessment(const AssessFlags& flags, const std::vector<std::string>& words) {
  check_controller(words);
  const std::vector<AxisValue> worlds = worlds_of(flags, words.front());
  std::vector<AxisValue> seeds = seeds_of(flags.seeds);
  const hal::Config config = hal::Config::from_command_line({}, {});
  std::string robot = config.text("robot");
  for (const auto& [key, text] : flags.sweep.settings) {
    if (key == "robot") robot = text;
  }
  Assessment out;
  out.no_collisions = flags.no_collisions;
  read_goals(out, flags, worlds, robot);
  out.plan = make_plan(flags.sweep, words);
  out.plan.put({AxisKind::Setting, "world", worlds});
  out.plan.put({AxisKind::Setting, "seed", std::move(seeds)});
  if (!is_given(flags, "time_limit")) {
    // A part of what is assessed: with it among the axes another limit is another run.
    const bool is_set = config.is_set("time_limit");
    out.plan.put({AxisKind::Setting,
                  "time_limit",
                  {{is_set ? config.text("time_limit") : kDefaultTimeLimit, {"--time-limit"}}}});
  }
  out.plan.results = (fs::path(flags.out) / "runs.db").string();
  return out;
}

}  // namespace eyebridge::apps
