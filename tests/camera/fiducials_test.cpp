#include "eyebridge/camera/fiducials.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/files/load.hpp"
#include "scenes.hpp"

namespace eyebridge::camera::testing {
namespace {

using ::testing::HasSubstr;

world::WorldModel room(std::vector<world::Wall> walls) {
  world::WorldModel model = empty_room();
  model.walls = std::move(walls);
  return model;
}

TEST(PlaceFiducials, AWallInTheRoomHasThemOnBothSides) {
  const auto all = place_fiducials(room({{{1.0, 2.0}, {1.36, 2.0}}}));
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].id, 0);
  EXPECT_EQ(all[1].id, 1);
  EXPECT_NEAR(all[0].facing, kPi / 2, 1e-12);  // the left side first
  EXPECT_NEAR(all[1].facing, -kPi / 2, 1e-12);
  for (const Fiducial& fiducial : all) {
    EXPECT_NEAR(fiducial.centre.x, 1.18, 1e-12);
    EXPECT_NEAR(fiducial.centre.y, 2.0, 1e-12);
    EXPECT_NEAR(fiducial.z, 0.1, 1e-12);
    EXPECT_NEAR(fiducial.size, 0.08, 1e-12);
  }
}

TEST(PlaceFiducials, TheBoundaryHasThemInsideOnly) {
  const auto all = place_fiducials(room({{{0.0, 1.0}, {0.0, 1.3}}, {{4.0, 1.0}, {4.0, 1.3}}}));
  ASSERT_EQ(all.size(), 2U);
  EXPECT_NEAR(all[0].facing, 0.0, 1e-12);
  EXPECT_NEAR(std::abs(all[1].facing), kPi, 1e-12);
}

TEST(PlaceFiducials, AThickWallHasThemOnItsFaces) {
  const auto all = place_fiducials(room({{{1.0, 2.0}, {1.36, 2.0}, 0.1}}));
  ASSERT_EQ(all.size(), 2U);
  EXPECT_NEAR(all[0].centre.y, 2.05, 1e-12);
  EXPECT_NEAR(all[1].centre.y, 1.95, 1e-12);
}

TEST(PlaceFiducials, ALongWallHasSeveralAtEqualDistances) {
  const auto all = place_fiducials(room({{{0.5, 0.0}, {2.5, 0.0}}}), {.spacing = 0.5});
  ASSERT_EQ(all.size(), 4U);
  // As one faces the wall (from the north, looking south) left is east.
  EXPECT_NEAR(all[0].centre.x, 2.25, 1e-12);
  EXPECT_NEAR(all[3].centre.x, 0.75, 1e-12);
}

TEST(PlaceFiducials, ThoseOnSmallWallsAreSmallerSoThatTheMarginFits) {
  const world::Wall low{{1.0, 1.0}, {1.36, 1.0}, 0.0, 0.06};
  const world::Wall narrow{{1.0, 2.0}, {1.05, 2.0}};
  for (const world::Wall& wall : {low, narrow}) {
    const auto all = place_fiducials(room({wall}));
    ASSERT_EQ(all.size(), 2U);
    EXPECT_NEAR(with_margin(all[0]), std::min(wall.height, norm(wall.b - wall.a)), 1e-12);
  }
  EXPECT_TRUE(place_fiducials(room({{{1.0, 2.0}, {1.01, 2.0}}})).empty());
}

TEST(PlaceFiducials, AFixedHeightIsKeptAndLimitsTheSize) {
  const auto all = place_fiducials(room({{{1.0, 2.0}, {1.36, 2.0}}}), {.height = 0.17});
  ASSERT_EQ(all.size(), 2U);
  EXPECT_NEAR(all[0].z, 0.17, 1e-12);
  EXPECT_NEAR(with_margin(all[0]), 2 * 0.03, 1e-12);
}

TEST(PlaceFiducials, AWallThatTouchesAnotherIsNotInFrontOfAFiducial) {
  const world::Wall barrier{{0.0, 2.0}, {1.0, 2.0}};
  const world::Wall post{{0.5, 2.0}, {0.5, 3.0}, 0.1};
  const auto all = place_fiducials(room({barrier, post}), {.spacing = 1.0});
  std::vector<double> north;
  for (const Fiducial& fiducial : all) {
    if (fiducial.centre.y == 2.0 && fiducial.facing > 0) north.push_back(fiducial.centre.x);
  }
  // Left and right of the post, each in the middle of what is free.
  ASSERT_EQ(north.size(), 2U);
  EXPECT_NEAR(std::min(north[0], north[1]), 0.225, 1e-9);
  EXPECT_NEAR(std::max(north[0], north[1]), 0.775, 1e-9);
}

TEST(PlaceFiducials, AWallThatIsDrawnTwiceIsMarkedOnce) {
  const world::Wall wall{{1.0, 2.0}, {1.36, 2.0}};
  EXPECT_EQ(place_fiducials(room({wall, {wall.b, wall.a}})).size(), 2U);
}

TEST(PlaceFiducials, InAMazeEveryVisibleFaceHasOne) {
  const auto maze = files::load_scenario(EYEBRIDGE_SOURCE_DIR "/worlds/maze-5.maz").world;
  const auto all = place_fiducials(maze);
  std::size_t faces = 0;
  for (const world::Wall& wall : maze.walls) {
    const Vec2 middle = 0.5 * (wall.a + wall.b);
    const bool boundary = middle.x < 1e-9 || middle.y < 1e-9 || middle.x > maze.width - 1e-9 ||
                          middle.y > maze.height - 1e-9;
    faces += boundary ? 1 : 2;
  }
  EXPECT_EQ(all.size(), faces);
  EXPECT_EQ(all, place_fiducials(maze));
}

TEST(PlaceFiducials, MoreThanThereAreIsAnErrorThatSaysWhatHelps) {
  world::WorldModel model = empty_room();
  model.width = model.height = 100.0;
  model.walls = {{{1.0, 50.0}, {99.0, 50.0}}};
  EXPECT_EQ(place_fiducials(model, {.spacing = 0.5}).size(), 392U);
  try {
    place_fiducials(model, {.spacing = 0.1});
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.text(), HasSubstr("1000"));
    EXPECT_THAT(error.text(), HasSubstr("spacing"));
  }
}

TEST(PlaceFiducials, ALayoutThatCannotBeIsAnError) {
  for (const FiducialLayout& layout :
       {FiducialLayout{.size = 0.0}, FiducialLayout{.size = 2.0}, FiducialLayout{.spacing = 0.0},
        FiducialLayout{.height = -1.0}, FiducialLayout{.size = std::nan("")}}) {
    EXPECT_THROW(place_fiducials(empty_room(), layout), ConfigError);
  }
}

class FiducialBitsOf : public ::testing::TestWithParam<FiducialFamily> {};

TEST_P(FiducialBitsOf, EachHasABlackBorderAndIsLikeNoOtherHoweverTurned) {
  const auto cells = static_cast<std::size_t>(cells_of(GetParam()));
  const auto turned = [&](const FiducialBits& bits) {
    FiducialBits out(bits.size());
    for (std::size_t row = 0; row < cells; ++row) {
      for (std::size_t column = 0; column < cells; ++column) {
        out[column * cells + (cells - 1 - row)] = bits[row * cells + column];
      }
    }
    return out;
  };
  std::set<FiducialBits> seen;
  for (int id = 0; id < count_of(GetParam()); ++id) {
    FiducialBits bits = fiducial_bits(GetParam(), id);
    ASSERT_EQ(bits.size(), cells * cells);
    for (std::size_t i = 0; i < cells; ++i) {
      EXPECT_EQ(bits[i] + bits[bits.size() - 1 - i] + bits[i * cells], 0);
    }
    for (int turn = 0; turn < 4; ++turn, bits = turned(bits)) {
      EXPECT_TRUE(seen.insert(bits).second) << id;
    }
  }
  EXPECT_THROW(fiducial_bits(GetParam(), -1), std::out_of_range);
  EXPECT_THROW(fiducial_bits(GetParam(), count_of(GetParam())), std::out_of_range);
}

INSTANTIATE_TEST_SUITE_P(Families, FiducialBitsOf,
                         ::testing::Values(FiducialFamily::Aruco5x5, FiducialFamily::Tag36h11,
                                           FiducialFamily::Tag25h9, FiducialFamily::Tag16h5));

TEST(FiducialFamilies, HaveNames) {
  EXPECT_EQ(family_named("tag25h9"), FiducialFamily::Tag25h9);
  EXPECT_EQ(family_named("aruco"), FiducialFamily::Aruco5x5);
  EXPECT_FALSE(family_named("tag"));
}

}  // namespace
}  // namespace eyebridge::camera::testing
