#include "sim/repeats.hpp"

#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"

namespace eyebridge::hal {
namespace {

/// Turns by `step` degrees once a second until `repeats` says something, for `limit` seconds at
/// most; `stray` radians are added to each turn. The seconds that it took, and what was said.
std::pair<int, std::size_t> turn(Repeats& repeats, double step, int limit, double stray = 0.0) {
  double theta = 0.0;
  for (int second = 0; second < limit; ++second) {
    const auto headings = repeats.add(from_seconds(second), {1.0, 2.0, wrap_angle(theta)});
    if (headings) return {second, *headings};
    theta += deg_to_rad(step) + stray;
  }
  return {limit, 0};
}

TEST(Repeats, ARobotThatTurnsToTheSameHeadingsForAMinuteIsNoticedOnce) {
  Repeats repeats;
  // The first round finds 36 headings, the next two meet each of them again.
  EXPECT_EQ(turn(repeats, 10, 1000), (std::pair{107, std::size_t{36}}));
  EXPECT_EQ(turn(repeats, 10, 1000), (std::pair{1000, std::size_t{0}}));
}

TEST(Repeats, NotBeforeAMinuteIsOver) {
  Repeats repeats;
  EXPECT_EQ(turn(repeats, 90, 1000), (std::pair{63, std::size_t{4}}));
}

TEST(Repeats, HeadingsThatScatterAreNoRepeats) {
  Repeats repeats;
  EXPECT_EQ(turn(repeats, 10, 1000, 1e-4).second, 0u);
}

TEST(Repeats, CommandsWithoutATurnAreNoRepeats) {
  Repeats repeats;
  for (int second = 0; second < 1000; ++second) {
    EXPECT_FALSE(repeats.add(from_seconds(second), {1.0, 2.0, second < 5 ? 0.0 : 1.5}));
  }
}

TEST(Repeats, APauseBetweenTurnsBeginsTheMinuteAnew) {
  Repeats repeats;
  int second = 0;
  for (; second < 20; ++second) {
    EXPECT_FALSE(repeats.add(from_seconds(second), {1.0, 2.0, second % 2 == 0 ? 0.0 : 1.5}));
  }
  for (second = 200; second < 259; ++second) {
    EXPECT_FALSE(repeats.add(from_seconds(second), {1.0, 2.0, second % 2 == 0 ? 0.0 : 1.5}));
  }
}

TEST(Repeats, ARobotThatStandsOrMovesOnIsNone) {
  Repeats repeats;
  EXPECT_EQ(turn(repeats, 0, 1000).second, 0u);
  for (int second = 0; second < 1000; ++second) {
    const double x = 0.001 * (second / 72);  // on to another spot after each second round
    EXPECT_FALSE(repeats.add(from_seconds(second), {x, 0.0, wrap_angle(deg_to_rad(10 * second))}));
  }
}

}  // namespace
}  // namespace eyebridge::hal
