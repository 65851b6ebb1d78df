#include "eyebridge/camera/birdseye.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "scenes.hpp"

namespace eyebridge::camera::testing {
namespace {

constexpr int kBorder = 20;
// 4 m in 400 pixels: 1 cm a pixel. Above the map is one border, below it are two.
constexpr BirdseyeOptions kOptions{400 + 3 * kBorder};

world::Scene scene_of(world::WorldModel model) {
  world::Scene scene;
  scene.model = std::make_shared<const world::WorldModel>(std::move(model));
  return scene;
}

Rgb at(const Frame& frame, double x, double y) {
  const auto row = frame.row(static_cast<int>(std::lround(kBorder + 100.0 * (4.0 - y) - 0.5)));
  const auto i = 3 * static_cast<std::size_t>(std::lround(kBorder + 100.0 * x - 0.5));
  return {row[i], row[i + 1], row[i + 2]};
}

TEST(Birdseye, IsAsLargeAsAskedFor) {
  const Frame frame = draw_birdseye(scene_of(empty_room()), {}, kOptions);
  EXPECT_EQ(frame.height, kOptions.longest_side);
  EXPECT_EQ(frame.width, 400 + 2 * kBorder);
  world::WorldModel wide = empty_room();
  wide.height = 1.0;
  const Frame other = draw_birdseye(scene_of(wide), {}, {500});
  EXPECT_EQ(other.width, 500);
  EXPECT_LT(other.height, 250);
}

TEST(Birdseye, AWallHasItsColourItsPlaceAndItsThickness) {
  world::WorldModel model = empty_room();
  world::Wall wall;
  wall.a = {1.0, 3.0};
  wall.b = {2.0, 3.0};
  wall.thickness = 0.2;
  wall.colour = kRed;
  model.walls = {wall};
  const Frame frame = draw_birdseye(scene_of(model), {}, kOptions);
  for (const double y : {2.92, 3.0, 3.08}) EXPECT_EQ(at(frame, 1.55, y), kRed) << y;
  for (const double y : {2.88, 3.12}) EXPECT_NE(at(frame, 1.55, y), kRed) << y;
  EXPECT_NE(at(frame, 0.95, 3.0), kRed);
  EXPECT_NE(at(frame, 2.05, 3.0), kRed);
}

TEST(Birdseye, ABareWallIsTwoPixelsWideAndDarkWhenItWouldNotShow) {
  world::WorldModel model = empty_room();
  world::Wall wall;
  wall.a = {1.0, 2.5};
  wall.b = {2.0, 2.5};
  model.walls = {wall};
  const Frame frame = draw_birdseye(scene_of(model), {}, kOptions);
  int dark = 0;
  for (int i = -5; i < 5; ++i) dark += at(frame, 1.5, 2.5 + 0.005 + 0.01 * i).r < 128 ? 1 : 0;
  EXPECT_EQ(dark, 2);
}

TEST(Birdseye, BodiesMarkersAndTrailsAreWhereTheyBelong) {
  world::WorldModel model = empty_room();
  model.markers.push_back({{0.5, 0.5}, {255, 0, 255}});
  world::Scene scene = scene_of(model);
  scene.bodies = {{0, world::BodyShape::Robot, {3.0, 1.0, 0.0}, 0.2, 0.1, kGreen},
                  {1, world::BodyShape::Ball, {3.5, 3.5, 0.0}, 0.1, 0.2, kRed}};
  const Trail trail{{0, 0, 255}, {{1.0, 1.5}, {2.0, 1.5}}};
  const Frame frame = draw_birdseye(scene, {&trail, 1}, kOptions);
  EXPECT_EQ(at(frame, 0.5, 0.5), (Rgb{255, 0, 255}));
  EXPECT_EQ(at(frame, 3.505, 3.505), kRed);
  EXPECT_EQ(at(frame, 1.5, 1.505), (Rgb{0, 0, 255}));
  EXPECT_EQ(at(frame, 2.86, 1.0), kGreen);  // its back
  EXPECT_NE(at(frame, 3.1, 1.0), kGreen);   // the heading mark
  EXPECT_NE(at(frame, 3.0, 1.25), kGreen);
}

TEST(Birdseye, TheHeadingMarkTurnsWithTheRobot) {
  world::Scene scene = scene_of(empty_room());
  scene.bodies = {{0, world::BodyShape::Robot, {3.0, 1.0, 1.5707963267948966}, 0.2, 0.1, kGreen}};
  const Frame frame = draw_birdseye(scene, {}, kOptions);
  EXPECT_NE(at(frame, 3.0, 1.1), kGreen);
  EXPECT_EQ(at(frame, 3.0, 0.86), kGreen);
}

TEST(Birdseye, APolygonLiesAsItIsTurned) {
  world::Scene scene = scene_of(empty_room());
  scene.bodies = {{0,
                   world::BodyShape::Polygon,
                   {3.0, 1.0, 1.5707963267948966},
                   0.5,
                   0.1,
                   kGreen,
                   std::make_shared<const std::vector<Vec2>>(
                       std::vector<Vec2>{{0.4, 0.1}, {-0.4, 0.1}, {-0.4, -0.1}, {0.4, -0.1}})}};
  const Frame frame = draw_birdseye(scene, {}, kOptions);
  for (const double y : {0.65, 1.0, 1.35}) EXPECT_EQ(at(frame, 3.0, y), kGreen) << y;
  EXPECT_NE(at(frame, 3.2, 1.0), kGreen);
  EXPECT_NE(at(frame, 2.8, 1.0), kGreen);
}

/// There is a dark pixel there, or beside it.
bool is_on_a_line(const Frame& frame, double x, double y) {
  for (const double dx : {-0.01, 0.0, 0.01}) {
    for (const double dy : {-0.01, 0.0, 0.01}) {
      const Rgb seen = at(frame, x + dx, y + dy);
      if (seen.r + seen.g + seen.b < 250) return true;
    }
  }
  return false;
}

TEST(Birdseye, APolygonHasALineAllRoundIt) {
  world::Scene scene = scene_of(empty_room());
  scene.bodies = {{0,
                   world::BodyShape::Polygon,
                   {3.0, 1.0, 0.0},
                   0.5,
                   0.1,
                   kGreen,
                   std::make_shared<const std::vector<Vec2>>(
                       std::vector<Vec2>{{0.4, -0.4}, {0.4, 0.4}, {-0.4, -0.4}})}};
  const Frame frame = draw_birdseye(scene, {}, kOptions);
  EXPECT_TRUE(is_on_a_line(frame, 3.4, 1.0));
  EXPECT_TRUE(is_on_a_line(frame, 3.0, 1.0));
  EXPECT_TRUE(is_on_a_line(frame, 3.0, 0.6)) << "from the last corner to the first";
  EXPECT_FALSE(is_on_a_line(frame, 3.2, 0.8));
}

TEST(Birdseye, StartsAreLettered) {
  world::WorldModel model = empty_room();
  const Frame without = draw_birdseye(scene_of(model), {}, kOptions);
  model.starts.push_back({'S', {1.5, 1.5, 0.0}});
  const Frame with = draw_birdseye(scene_of(model), {}, kOptions);
  int changed = 0;
  for (int i = -6; i <= 6; ++i) {
    for (int j = -6; j <= 6; ++j) {
      const double x = 1.505 + 0.01 * i;
      const double y = 1.505 + 0.01 * j;
      changed += at(with, x, y) == at(without, x, y) ? 0 : 1;
    }
  }
  EXPECT_GT(changed, 10);
}

TEST(Birdseye, AWorldWithoutSizeIsStillAPicture) {
  const Frame frame = draw_birdseye(scene_of({}), {}, {10});
  EXPECT_GT(frame.width, 0);
  EXPECT_GT(frame.height, 0);
}

}  // namespace
}  // namespace eyebridge::camera::testing
