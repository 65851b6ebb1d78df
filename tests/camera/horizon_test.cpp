#include "render/horizon.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include <gtest/gtest.h>

#include "eyebridge/base/random.hpp"

namespace eyebridge::camera::testing {
namespace {

constexpr double kReach = 0.8;
constexpr double kNear = 0.01;

struct Segment {
  Vec2 a;
  Vec2 b;
};

/// Depth of `segment` in direction `u`; infinite where it does not lie before the eye.
double depth_in(const Segment& segment, double u) {
  // (d, u d) = a + t (b - a), by Cramer's rule.
  const Vec2 along = segment.b - segment.a;
  const double turn = along.y - u * along.x;
  if (turn == 0.0) return std::numeric_limits<double>::infinity();
  const double t = (u * segment.a.x - segment.a.y) / turn;
  const double depth = segment.a.x + t * along.x;
  return t < 0.0 || t > 1.0 || depth < kNear ? std::numeric_limits<double>::infinity() : depth;
}

std::set<std::uint32_t> seen_by(const Horizon& horizon) {
  std::vector<std::uint32_t> walls;
  horizon.list_seen(walls);
  return {walls.begin(), walls.end()};
}

TEST(Horizon, SeesExactlyTheWallsThatAreNearestSomewhere) {
  Random random(5);
  for (int round = 0; round < 200; ++round) {
    std::vector<Segment> walls(30);  // many of them cross
    Horizon horizon;
    horizon.clear(kReach, kNear);
    for (std::uint32_t i = 0; i < walls.size(); ++i) {
      walls[i].a = {4.0 * random.uniform() - 0.5, 6.0 * random.uniform() - 3.0};
      walls[i].b = walls[i].a + Vec2{2.0 * random.uniform() - 1.0, 2.0 * random.uniform() - 1.0};
      horizon.add(walls[i].a, walls[i].b, i);
    }
    std::set<std::uint32_t> nearest;
    double farthest = 0.0;
    for (double u = -kReach; u < kReach; u += 0.0005) {
      const auto first = std::ranges::min_element(
          walls, {}, [&](const Segment& wall) { return depth_in(wall, u); });
      farthest = std::max(farthest, depth_in(*first, u));
      if (std::isinf(depth_in(*first, u))) continue;
      nearest.insert(static_cast<std::uint32_t>(first - walls.begin()));
    }
    const std::set<std::uint32_t> seen = seen_by(horizon);
    EXPECT_TRUE(std::ranges::includes(seen, nearest)) << round;
    EXPECT_LE(seen.size(), nearest.size() + 2) << round;  // slivers between two samples
    EXPECT_GE(horizon.farthest(), farthest * (1.0 - 1e-9)) << round;
  }
}

TEST(Horizon, WallsThatMeetAtACornerLeaveNoGap) {
  Horizon horizon;
  horizon.clear(kReach, kNear);
  const Vec2 corner{1.0, 1.0 / 3.0};
  horizon.add(corner, {1.3, 3.0}, 0);
  horizon.add({0.9, -3.0}, corner, 1);
  EXPECT_LT(horizon.farthest(), 1.3);
  horizon.add({2.0, -3.0}, {2.0, 3.0}, 2);
  EXPECT_EQ(seen_by(horizon), (std::set<std::uint32_t>{0, 1}));
}

TEST(Horizon, HidesWhatLiesBehindAndNothingElse) {
  Horizon horizon;
  horizon.clear(kReach, kNear);
  horizon.add({1.0, -0.2}, {1.0, 0.4}, 0);
  const auto hides = [&](double depth, double from, double to) {
    return horizon.hides(std::array{Vec2{depth, from}, Vec2{depth, to}});
  };
  EXPECT_TRUE(hides(2.0, -0.3, 0.7));
  EXPECT_FALSE(hides(2.0, -0.5, 0.7));
  EXPECT_FALSE(hides(2.0, -0.3, 0.9));
  EXPECT_FALSE(hides(0.9, -0.1, 0.1));
  EXPECT_FALSE(hides(1.0, -0.1, 0.1));
  EXPECT_FALSE(hides(kNear / 2, -0.1, 0.1));
}

TEST(Horizon, WhatIsTooNearHidesNothing) {
  Horizon horizon;
  horizon.clear(kReach, kNear);
  horizon.add({kNear / 2, -1.0}, {kNear / 2, 1.0}, 0);
  horizon.add({1.0, -1.0}, {1.0, 1.0}, 1);
  EXPECT_EQ(seen_by(horizon), (std::set<std::uint32_t>{1}));
}

TEST(Horizon, OfTwoWallsInOnePlaneBothAreSeen) {
  Horizon horizon;
  horizon.clear(kReach, kNear);
  horizon.add({1.0, -0.3}, {1.5, 0.3}, 0);
  horizon.add({1.5, 0.3}, {1.0, -0.3}, 1);
  EXPECT_EQ(seen_by(horizon), (std::set<std::uint32_t>{0, 1}));
}

TEST(Horizon, IsInfinitelyFarWhileADirectionIsOpen) {
  Horizon horizon;
  horizon.clear(kReach, kNear);
  horizon.add({1.0, -2.0}, {1.0, 0.7}, 0);
  EXPECT_TRUE(std::isinf(horizon.farthest()));
  horizon.add({1.2, 0.5}, {1.2, 2.0}, 1);
  EXPECT_NEAR(horizon.farthest(), 1.2, 1e-12);
}

}  // namespace
}  // namespace eyebridge::camera::testing
