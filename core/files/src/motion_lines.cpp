#include "motion_lines.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace eyebridge::files {
namespace {

constexpr std::array<std::string_view, 7> kMotionTraits = {
    "speeds", "waits", "acceleration", "yields", "follow", "flee", "wander"};

// Millimetres, and per second; seconds.
constexpr double kLeastSpeed = 0.1;
constexpr double kMostSpeed = 100000;
constexpr double kLeastDistance = 0.001;
constexpr double kLongestWait = 1e6;

/// "speeds V1 [V2 ...]", "waits S1 [S2 ...]": one number for each of the first legs or points.
template <class Read>
std::vector<double> read_each(const Statement& s, std::size_t most, std::string_view form,
                              Read read) {
  if (s.size() < 2) s.expect_arguments(1, form);
  if (s.size() - 1 > most) {
    s.fail(1 + most, std::to_string(s.size() - 1) + " numbers for a path of " +
                         std::to_string(most) + " legs: expected no more than that");
  }
  std::vector<double> values;
  for (std::size_t i = 1; i < s.size(); ++i) values.push_back(read(i));
  return values;
}

world::Reaction read_reaction(const Statement& s, const std::string& keyword) {
  using Kind = world::Reaction::Kind;
  world::Reaction reaction;
  if (keyword == "wander") {
    s.expect_arguments(1, "wander MM_PER_SECOND");
    reaction.kind = Kind::Wander;
  } else {
    s.expect_arguments({1, 2}, keyword + " MM_PER_SECOND [MM]");
    reaction.kind = keyword == "follow" ? Kind::Follow : Kind::Flee;
  }
  reaction.speed = s.millimetres(1, "the speed", kLeastSpeed, kMostSpeed);
  if (s.size() > 2) reaction.range = s.millimetres(2, "the distance", kLeastDistance);
  return reaction;
}

std::string numbers(std::string_view keyword, const std::vector<double>& values,
                    std::string (*write)(double)) {
  if (values.empty()) return {};
  std::string out(keyword);
  for (const double value : values) out += ' ' + write(value);
  return out + '\n';
}

}  // namespace

bool is_motion_trait(std::string_view keyword) {
  return std::ranges::find(kMotionTraits, keyword) != kMotionTraits.end();
}

bool begins_way(std::string_view keyword) {
  return keyword == "path" || keyword == "follow" || keyword == "flee" || keyword == "wander";
}

void read_motion_trait(const Statement& s, ObjectTraits& traits) {
  const std::string keyword = lower(s.text(0));
  if (keyword == "follow" || keyword == "flee" || keyword == "wander") {
    if (traits.path) s.fail(0, in_quotes(keyword) + " for one on a path: expected one of them");
    traits.reaction = read_reaction(s, keyword);
    traits.still = false;
    return;
  }
  if (keyword == "yields") {
    if (!traits.path && !traits.reaction) {
      s.fail(0, "'yields' of what stands: expected 'path', 'follow', 'flee' or 'wander' before it");
    }
    s.expect_arguments(1, "yields MM");
    traits.yields_within = s.millimetres(1, "the distance", 0);
    return;
  }
  if (!traits.path) s.fail(0, in_quotes(keyword) + " without a path: expected 'path' before it");
  world::Path& path = *traits.path;
  if (keyword == "speeds") {
    path.leg_speeds = read_each(
        s, path.leg_count(), "speeds MM_PER_SECOND ...",
        [&](std::size_t i) { return s.millimetres(i, "the speed", kLeastSpeed, kMostSpeed); });
  } else if (keyword == "waits") {
    path.waits = read_each(s, path.leg_count(), "waits SECONDS ...", [&](std::size_t i) {
      return s.number(i, "the time in seconds", 0, kLongestWait);
    });
  } else {
    s.expect_arguments(1, "acceleration MM_PER_SECOND_SQUARED");
    path.acceleration = s.millimetres(1, "the acceleration", 1, kMostSpeed);
  }
}

std::string motion_lines(const std::optional<world::Path>& path,
                         const std::optional<world::Reaction>& reaction, double yields_within) {
  std::string out;
  if (path) {
    out += numbers("speeds", path->leg_speeds, write_millimetres);
    out += numbers("waits", path->waits, decimal);
    if (path->acceleration > 0.0) {
      out += "acceleration " + write_millimetres(path->acceleration) + '\n';
    }
  }
  if (reaction) {
    constexpr std::array<std::string_view, 3> kNames = {"follow", "flee", "wander"};
    out += std::string(kNames.at(static_cast<std::size_t>(reaction->kind))) + ' ' +
           write_millimetres(reaction->speed);
    if (reaction->range < std::numeric_limits<double>::infinity()) {
      out += ' ' + write_millimetres(reaction->range);
    }
    out += '\n';
  }
  if (yields_within > 0.0) out += "yields " + write_millimetres(yields_within) + '\n';
  return out;
}

}  // namespace eyebridge::files
