#include "eyebridge/planning/path_progress.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace eyebridge::planning {
namespace {

PathProgress corner() { return PathProgress({{0, 0}, {2, 0}, {2, 0}, {2, 3}}); }

TEST(PathProgress, FindsTheNearestPlaceWithinItsWindow) {
  PathProgress progress = corner();
  progress.advance({0.7, 0.4}, 1.0);
  EXPECT_DOUBLE_EQ(progress.done(), 0.7);
  progress.advance({1.9, 1.0}, 10.0);
  EXPECT_DOUBLE_EQ(progress.done(), 3.0);
  EXPECT_DOUBLE_EQ(progress.remaining(), 2.0);
  progress.advance({0.1, 0.0}, 10.0);
  EXPECT_DOUBLE_EQ(progress.done(), 3.0);
  progress.advance({2.0, 3.0}, 0.5);
  EXPECT_DOUBLE_EQ(progress.done(), 3.5);
  progress.advance({9.0, 9.0}, 10.0);
  EXPECT_DOUBLE_EQ(progress.remaining(), 0.0);
}

TEST(PathProgress, DoesNotJumpToWhereThePathComesBack) {
  PathProgress progress({{0, 0}, {4, 0}, {4, 0.1}, {0, 0.1}});
  progress.advance({1.0, 0.09}, 2.0);
  EXPECT_DOUBLE_EQ(progress.done(), 1.0);
}

TEST(PathProgress, LooksAheadAroundCorners) {
  PathProgress progress = corner();
  progress.advance({1.5, 0.0}, 10.0);
  EXPECT_EQ(progress.ahead(0.25), (Vec2{1.75, 0.0}));
  EXPECT_EQ(progress.ahead(1.5), (Vec2{2.0, 1.0}));
  EXPECT_EQ(progress.ahead(50.0), (Vec2{2.0, 3.0}));
}

TEST(PathProgress, LeavesACircleAtItsDistance) {
  PathProgress progress = corner();
  const Vec2 robot{1.5, -0.3};
  progress.advance(robot, 10.0);
  const Vec2 aim = progress.leaving_circle(robot, 1.3);
  EXPECT_DOUBLE_EQ(aim.x, 2.0);
  EXPECT_NEAR(norm(aim - robot), 1.3, 1e-12);
  EXPECT_GT(aim.y, 0.0);
  EXPECT_EQ(progress.leaving_circle(robot, 0.2), (Vec2{1.5, 0.0}));
  EXPECT_EQ(progress.leaving_circle(robot, 9.0), (Vec2{2.0, 3.0}));
}

TEST(PathProgress, StandsOnASinglePointAndRefusesNone) {
  PathProgress progress({{1, 2}});
  progress.advance({5, 5}, 1.0);
  EXPECT_EQ(progress.remaining(), 0.0);
  EXPECT_EQ(progress.ahead(1.0), (Vec2{1, 2}));
  EXPECT_EQ(progress.leaving_circle({5, 5}, 100.0), (Vec2{1, 2}));
  EXPECT_THROW(PathProgress({}), std::invalid_argument);
}

}  // namespace
}  // namespace eyebridge::planning
