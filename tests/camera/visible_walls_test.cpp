#include "render/visible_walls.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "eyebridge/base/random.hpp"
#include "render/mesh.hpp"
#include "scenes.hpp"

namespace eyebridge::camera::testing {
namespace {

/// Numbers of the walls whose quads are among `indices`; all walls are bare lines.
std::set<std::size_t> walls_in(const std::vector<std::uint32_t>& indices) {
  std::set<std::size_t> walls;
  for (const std::uint32_t index : indices) walls.insert(index / 4);
  return walls;
}

/// The first wall that a ray meets, by trying all of them; nothing when two are met at one place.
std::optional<std::size_t> first_hit(const std::vector<world::Wall>& walls, Vec2 from, Vec2 ray) {
  double best = 1e9;
  double second = 1e9;
  std::optional<std::size_t> hit;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const Vec2 along = walls[i].b - walls[i].a;
    const double turn = cross(ray, along);
    if (turn == 0.0) continue;
    const Vec2 to = walls[i].a - from;
    const double t = cross(to, along) / turn;
    const double s = cross(to, ray) / turn;
    if (s < 0.0 || s > 1.0 || t < 0.01) continue;
    second = std::min(second, std::max(t, best));
    if (t < best) {
      best = t;
      hit = i;
    }
  }
  return second - best < 1e-6 ? std::nullopt : hit;
}

std::vector<world::Wall> random_walls(std::size_t count, Random& random) {
  std::vector<world::Wall> walls(count);
  for (world::Wall& wall : walls) {
    wall.a = {8.0 * random.uniform(), 8.0 * random.uniform()};
    wall.b = wall.a + Vec2{random.uniform() - 0.5, random.uniform() - 0.5};
    wall.height = random.chance(0.3) ? 0.15 : 0.2;
  }
  return walls;
}

/// `quads` are the upright faces that the quads of `walls` show; eyes in a place that is `taken`
/// are not tried.
void expect_nothing_visible_missing(const std::vector<world::Wall>& walls,
                                    const std::vector<world::Wall>& quads,
                                    const std::function<bool(Vec2)>& taken, Random& random) {
  VisibleWalls visible(walls);
  std::vector<std::uint32_t> indices;
  int seen = 0;
  for (int place = 0; place < 40; ++place) {
    Eye eye{8.0 * random.uniform(), 8.0 * random.uniform(), 0.1, 6.28 * random.uniform(), 0, 1.1};
    if (taken({eye.x, eye.y})) continue;
    eye.pitch = place % 2 == 0 ? 0.0 : 0.8 * random.uniform() - 0.4;
    visible.select(Lens(eye, 320, 240, 100.0), indices);
    const std::set<std::size_t> chosen = walls_in(indices);
    // The horizontal plane of the eye is in view: of each bearing in it the first wall must be
    // there.
    for (double bearing = -0.54; bearing < 0.54; bearing += 0.002) {
      const double angle = eye.heading + bearing;
      const auto hit = first_hit(quads, {eye.x, eye.y}, {std::cos(angle), std::sin(angle)});
      if (!hit) continue;
      ++seen;
      ASSERT_TRUE(chosen.contains(*hit)) << "wall " << *hit << " from place " << place;
    }
  }
  EXPECT_GT(seen, 10000);
}

bool nowhere(Vec2) { return false; }

TEST(VisibleWalls, NothingThatIsSeenIsLeftOutOfAMaze) {
  Random random(3);
  const std::vector<world::Wall> walls = maze_scene(27, 4).model->walls;
  expect_nothing_visible_missing(walls, walls, nowhere, random);
}

TEST(VisibleWalls, NothingThatIsSeenIsLeftOutAmongWallsAtRandom) {
  Random random(4);
  const std::vector<world::Wall> walls = random_walls(400, random);
  expect_nothing_visible_missing(walls, walls, nowhere, random);
}

TEST(VisibleWalls, AnEyeAboveTheWallsSeesOverThem) {
  world::Wall near_wall;
  near_wall.a = {1.0, -2.0};
  near_wall.b = {1.0, 2.0};
  world::Wall far_wall = near_wall;
  far_wall.a.x = far_wall.b.x = 3.0;
  VisibleWalls visible({near_wall, far_wall});
  std::vector<std::uint32_t> indices;
  visible.select(Lens({0, 0, 0.1, 0, 0, 1.0}, 320, 240, 10.0), indices);
  EXPECT_EQ(walls_in(indices), (std::set<std::size_t>{0}));
  visible.select(Lens({0, 0, 0.5, 0, 0, 1.0}, 320, 240, 10.0), indices);
  EXPECT_EQ(walls_in(indices), (std::set<std::size_t>{0, 1}));
}

TEST(VisibleWalls, ALowWallHidesNoTallOne) {
  world::Wall low;
  low.a = {1.0, -2.0};
  low.b = {1.0, 2.0};
  low.height = 0.15;
  world::Wall tall = low;
  tall.a.x = tall.b.x = 3.0;
  tall.height = 0.3;
  VisibleWalls visible({low, tall});
  std::vector<std::uint32_t> indices;
  visible.select(Lens({0, 0, 0.1, 0, 0, 1.0}, 320, 240, 10.0), indices);
  EXPECT_EQ(walls_in(indices), (std::set<std::size_t>{0, 1}));
}

/// Whether the top is drawn of a low wall `thickness` thick that lies along the eye's axis, behind
/// a tall one which hides 0.4 m to either side there.
bool top_shows_beside_a_tall_wall(double thickness) {
  world::Wall tall;
  tall.a = {1.0, -0.2};
  tall.b = {1.0, 0.2};
  tall.height = 0.3;
  world::Wall low;
  low.a = {2.0, 0.0};
  low.b = {2.3, 0.0};
  low.height = 0.2;
  low.thickness = thickness;
  VisibleWalls visible({tall, low});
  std::vector<std::uint32_t> indices;
  visible.select(Lens({0, 0, 0.25, 0, 0, 1.0}, 320, 240, 10.0), indices);
  return walls_in(indices).contains(kQuadsOfLine + kQuadsOfBox - 1);
}

TEST(VisibleWalls, ATopIsDrawnWhereItsEdgesShow) {
  EXPECT_TRUE(top_shows_beside_a_tall_wall(1.0));
  EXPECT_TRUE(top_shows_beside_a_tall_wall(0.82));
  EXPECT_FALSE(top_shows_beside_a_tall_wall(0.78));
}

TEST(VisibleWalls, AWallBehindTheEyeIsLeftOut) {
  world::Wall wall;
  wall.a = {-1.0, -1.0};
  wall.b = {-1.0, 1.0};
  VisibleWalls visible({wall});
  std::vector<std::uint32_t> indices;
  visible.select(Lens({0, 0, 0.1, 0, 0, 1.0}, 320, 240, 10.0), indices);
  EXPECT_TRUE(indices.empty());
  visible.select(Lens({0, 0, 0.1, 3.14, 0, 1.0}, 320, 240, 10.0), indices);
  EXPECT_EQ(indices.size(), 6U);
}

TEST(VisibleWalls, NothingThatIsSeenIsLeftOutAmongThickWalls) {
  Random random(6);
  std::vector<world::Wall> thick = random_walls(150, random);
  for (world::Wall& wall : thick) {
    wall.thickness = 0.02 + 0.2 * random.uniform();
    wall.height = 0.2;
  }
  // The faces as walls of their own, in the order of the quads; a top is met by no level ray.
  std::vector<world::Wall> faces;
  for (const world::Wall& wall : thick) {
    const auto corner = outline_of(wall);
    for (const auto& [a, b] : {std::pair{0U, 1U}, {2U, 3U}, {1U, 2U}, {3U, 0U}}) {
      faces.push_back(wall);
      faces.back().a = corner[a];
      faces.back().b = corner[b];
    }
    faces.push_back(wall);
    faces.back().a = faces.back().b = {-100.0, -100.0};
  }
  const auto inside = [&](Vec2 at) {
    return std::ranges::any_of(thick, [&](const world::Wall& wall) {
      const Vec2 along = wall.b - wall.a;
      const double length = norm(along);
      const double t = dot(at - wall.a, along) / length;
      return std::abs(cross(along, at - wall.a)) / length <= wall.thickness / 2 && t >= 0.0 &&
             t <= length;
    });
  };
  expect_nothing_visible_missing(thick, faces, inside, random);
}

TEST(VisibleWalls, OfAMazeHardlyMoreIsDrawnThanIsSeen) {
  const world::Scene scene = maze_scene(43, 7);
  const std::vector<world::Wall>& walls = scene.model->walls;
  VisibleWalls visible(walls);
  std::vector<std::uint32_t> indices;
  std::size_t drawn = 0;
  std::size_t seen = 0;
  for (int place = 0; place < 40; ++place) {
    const Eye eye{0.15 + 0.3 * place, 0.15 + 0.3 * (place * 7 % 43), 0.1, 0.4 * place, 0, 1.1};
    visible.select(Lens(eye, 320, 240, 100.0), indices);
    drawn += walls_in(indices).size();
    std::set<std::size_t> hits;
    for (double bearing = -0.549; bearing < 0.55; bearing += 0.002) {
      const double angle = eye.heading + bearing;
      if (const auto hit = first_hit(walls, {eye.x, eye.y}, {std::cos(angle), std::sin(angle)})) {
        hits.insert(*hit);
      }
    }
    seen += hits.size();
  }
  EXPECT_LT(static_cast<double>(drawn), 1.2 * static_cast<double>(seen));
}

TEST(VisibleWalls, HideBodiesBehindThemThatAreNoTaller) {
  world::Wall wall;
  wall.a = {1.0, -0.3};
  wall.b = {1.0, 0.3};
  VisibleWalls visible({wall});
  std::vector<std::uint32_t> indices;
  visible.select(Lens({0, 0, 0.1, 0, 0, 1.0}, 320, 240, 10.0), indices);
  EXPECT_TRUE(visible.hide({2.0, 0.0}, 0.05, 0.2));
  EXPECT_FALSE(visible.hide({2.0, 0.0}, 0.05, 0.21));  // looks over it
  EXPECT_FALSE(visible.hide({2.0, 0.58}, 0.05, 0.1));  // looks out at its end
  EXPECT_FALSE(visible.hide({0.97, 0.0}, 0.05, 0.1));  // touches it
  EXPECT_FALSE(visible.hide({0.5, 0.0}, 0.05, 0.1));
  visible.select(Lens({0, 0, 0.3, 0, 0, 1.0}, 320, 240, 10.0), indices);
  EXPECT_FALSE(visible.hide({2.0, 0.0}, 0.05, 0.2));  // now the eye looks over it
}

TEST(VisibleWalls, OfABigMazeOnlyAFewWallsAreDrawn) {
  const world::Scene scene = maze_scene(44, 7);
  VisibleWalls visible(scene.model->walls);
  std::vector<std::uint32_t> indices;
  const Shot shot = maze_shot(scene, 320, 240);
  visible.select(Lens(shot.eye, 320, 240, 100.0), indices);
  EXPECT_GT(scene.model->walls.size(), 2000U);
  EXPECT_LT(walls_in(indices).size(), 100U);
}

TEST(VisibleWalls, OfAThickWallOnlyTheFacesTowardsTheEyeAreDrawn) {
  world::Wall wall;
  wall.a = {1.0, -0.2};
  wall.b = {1.0, 0.2};
  wall.thickness = 0.1;
  VisibleWalls visible({wall});
  std::vector<std::uint32_t> indices;
  visible.select(Lens({0, 0, 0.1, 0, 0, 1.0}, 320, 240, 10.0), indices);
  EXPECT_EQ(indices.size(), 6U);  // the face towards it
  visible.select(Lens({0, 0, 0.3, 0, 0, 1.0}, 320, 240, 10.0), indices);
  EXPECT_EQ(indices.size(), 12U);  // and the top
  visible.select(Lens({0, 0.8, 0.3, -0.6, 0, 1.0}, 320, 240, 10.0), indices);
  EXPECT_EQ(indices.size(), 18U);  // and an end
}

}  // namespace
}  // namespace eyebridge::camera::testing
