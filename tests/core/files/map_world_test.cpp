// Maps of ROS as worlds: walls around what is black, at the map's own places.
#include <algorithm>
#include <cmath>
#include <random>

#include <gmock/gmock.h>

#include "eyebridge/base/units.hpp"
#include "eyebridge/files/map_files.hpp"
#include "eyebridge/world/world.hpp"
#include "reading.hpp"

namespace eyebridge::files {
namespace {

constexpr double kFarAway = 100.0;  // metres: nothing is there
const std::string kMapCases = EYEBRIDGE_SHARED_DIR "/cases/maps/";

std::string yaml(const std::string& image, const std::string& origin) {
  return "image: " + image + "\nresolution: 0.1\norigin: " + origin +
         "\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
}

std::string pgm(int columns, int rows, const std::string& pixels) {
  std::string text = "P5\n" + std::to_string(columns) + " " + std::to_string(rows) + "\n255\n";
  for (const char c : pixels) text += c == '#' ? '\0' : c == '.' ? '\xFE' : '\xCD';
  return text;
}

/// Where a ray from the middle of a pixel along a row or column meets the first black pixel.
double first_black(const GreyPicture& picture, int x, int y, int dx, int dy) {
  for (int steps = 1;; ++steps) {
    const int at_x = x + steps * dx;
    const int at_y = y + steps * dy;
    if (at_x < 0 || at_y < 0 || at_x >= picture.columns || at_y >= picture.rows) return kFarAway;
    const auto i = static_cast<std::size_t>(at_y * picture.columns + at_x);
    if (picture.greys[i] < 50) return 0.1 * (steps - 0.5);
  }
}

TEST(MapWorld, RaysMeetWallsWhereTheMapIsBlack) {
  const Folder folder;
  std::mt19937 dice(3);
  int rays = 0;
  int wrong = 0;  // past a corner that was cut off
  for (int trial = 0; trial < 20; ++trial) {
    constexpr int kColumns = 24;
    constexpr int kRows = 17;
    std::string pixels(kColumns * kRows, '.');
    for (int block = 0; block < 8; ++block) {
      const int left = static_cast<int>(dice() % (kColumns - 4));
      const int top = static_cast<int>(dice() % (kRows - 4));
      for (int y = top; y < top + 1 + static_cast<int>(dice() % 3); ++y) {
        for (int x = left; x < left + 4; ++x) {
          pixels[static_cast<std::size_t>(y * kColumns + x)] = '#';
        }
      }
    }
    folder.write("m.pgm", pgm(kColumns, kRows, pixels));
    std::vector<Warning> warnings;
    const auto path = folder.write("m.yaml", yaml("m.pgm", "[-1.2, 0.7, 0]"));
    const MapFiles map = read_map_files(path, warnings);
    LoadOptions options;
    options.robot = "";
    const Scenario scenario = load_scenario(path, options);
    EXPECT_EQ(scenario.world.corner, (Vec2{-1.2, 0.7}));
    EXPECT_NEAR(scenario.world.width, 2.4, 1e-12);
    const world::World world(std::make_shared<const world::WorldModel>(scenario.world), 1);
    for (int y = 0; y < kRows; ++y) {
      for (int x = 0; x < kColumns; ++x) {
        if (pixels[static_cast<std::size_t>(y * kColumns + x)] == '#') continue;
        const Vec2 middle{-1.2 + 0.1 * (x + 0.5), 0.7 + 0.1 * (kRows - y - 0.5)};
        for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
          const double expected = first_black(map.picture, x, y, dx, dy);
          const double range =
              world.cast_ray(middle, {static_cast<double>(dx), static_cast<double>(-dy)}, kFarAway,
                             world::kNoBody);
          // Outlines are straightened by up to three quarters of a pixel.
          ++rays;
          if (std::abs(range - expected) > 0.075 + 1e-9) ++wrong;
        }
      }
    }
  }
  EXPECT_GT(rays, 10000);
  EXPECT_LT(wrong, rays / 100);
}

TEST(MapWorld, WallsAlongTheAxesAreWhereTheyAre) {
  const Folder folder;
  std::string pixels(30 * 20, '.');
  for (int y = 4; y < 9; ++y) {
    for (int x = 6; x < 21; ++x) pixels[static_cast<std::size_t>(y * 30 + x)] = '#';
  }
  folder.write("m.pgm", pgm(30, 20, pixels));
  const auto scenario = load_scenario(folder.write("m.yaml", yaml("m.pgm", "[-1, 2, 0]")));
  std::vector<Vec2> corners;
  for (const world::Wall& wall : scenario.world.walls) corners.push_back(wall.a);
  ASSERT_EQ(corners.size(), 4u);
  for (const Vec2 expected : {Vec2{-0.4, 3.6}, {1.1, 3.6}, {1.1, 3.1}, {-0.4, 3.1}}) {
    EXPECT_TRUE(std::ranges::any_of(corners, [&](Vec2 c) { return norm(c - expected) < 1e-9; }))
        << expected.x << " " << expected.y;
  }
}

TEST(MapWorld, AMapThatIsTurnedIsTurned) {
  const Folder folder;
  folder.write("m.pgm", pgm(5, 3, ".....##........"));
  LoadOptions options;
  options.robot = "";
  const auto straight = load_scenario(folder.write("a.yaml", yaml("m.pgm", "[1, 2, 0]")), options);
  const auto turned =
      load_scenario(folder.write("b.yaml", yaml("m.pgm", "[1, 2, 1.5707963267948966]")), options);
  ASSERT_EQ(straight.world.walls.size(), 4u);
  ASSERT_EQ(turned.world.walls.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 a = straight.world.walls[i].a - Vec2{1, 2};
    EXPECT_NEAR(turned.world.walls[i].a.x, 1 - a.y, 1e-9);
    EXPECT_NEAR(turned.world.walls[i].a.y, 2 + a.x, 1e-9);
  }
  EXPECT_NEAR(turned.world.corner.x, 0.7, 1e-9);
  EXPECT_NEAR(turned.world.width, 0.3, 1e-9);
  // The grid of the same map: cells as the pixels under them.
  std::vector<Warning> warnings;
  const auto grid = load_map(folder.path() / "b.yaml", warnings);
  EXPECT_EQ(grid.geometry().columns, 3);
  EXPECT_EQ(grid.geometry().rows, 5);
  EXPECT_GT(grid.probability(mapping::Cell{1, 0}), 0.9);
  EXPECT_GT(grid.probability(mapping::Cell{1, 1}), 0.9);
  EXPECT_LT(grid.probability(mapping::Cell{1, 2}), 0.1);
  EXPECT_LT(grid.probability(mapping::Cell{0, 0}), 0.1);
}

TEST(MapWorld, TheRobotStartsWhereItHasRoomAndNotInTheUnknown) {
  const Folder folder;
  // The middle is unknown, the room is on the right.
  std::string pixels;
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 60; ++x) {
      const bool wall = x == 30 || x == 59 || y == 0 || y == 19;
      pixels += x < 30 ? '?' : wall ? '#' : '.';
    }
  }
  folder.write("m.pgm", pgm(60, 20, pixels));
  const auto scenario = load_scenario(folder.write("m.yaml", yaml("m.pgm", "[-3, -1, 0]")));
  ASSERT_EQ(scenario.robots.size(), 1u);
  EXPECT_GT(scenario.robots[0].pose.x, 0.5);
  EXPECT_LT(scenario.robots[0].pose.x, 2.5);
  EXPECT_TRUE(scenario.warnings.empty());
}

TEST(MapWorld, TheCasesAreRead) {
  for (const char* name : {"good", "lab", "flow", "quoted-key", "png", "pgm16", "yaw"}) {
    std::vector<Warning> warnings;
    const auto grid = load_map(kMapCases + name + ".yaml", warnings);
    EXPECT_THAT(warnings, testing::IsEmpty()) << name;
    EXPECT_EQ(grid.geometry().columns * grid.geometry().rows, 24 * 16) << name;
    const auto scenario = load_scenario(kMapCases + name + ".yaml");
    EXPECT_FALSE(scenario.world.walls.empty()) << name;
    EXPECT_EQ(scenario.robots.size(), 1u) << name;
  }
  const auto lab = load_scenario(kMapCases + "lab.yaml");
  EXPECT_EQ(lab.world.corner, (Vec2{-1.2, -0.8}));
  for (const char* other : {"png", "pgm16", "flow"}) {
    EXPECT_EQ(load_scenario(kMapCases + other + ".yaml").world.walls, lab.world.walls) << other;
  }
}

TEST(MapWorld, MistakesAreNamed) {
  const Folder folder;
  folder.write("m.pgm", pgm(2, 1, "#."));
  const auto refusal = [&](const std::string& text) {
    const auto path = folder.write("m.yaml", text);
    return without(error_of([&] { load_scenario(path); }), folder.path().string() + "/");
  };
  EXPECT_EQ(refusal("image: gone.pgm\nresolution: 0.1\norigin: [0, 0, 0]\n"),
            "m.yaml:1:8: no such file: 'gone.pgm'");
  EXPECT_EQ(refusal("image: m.pgm\nresolution: 0.1\norigin: [0, 0]\n"),
            "m.yaml:3:9: origin has 2 numbers: expected 3, [x, y, yaw]");
  EXPECT_EQ(refusal("image: m.pgm\nresolution: x\norigin: [0, 0, 0]\n"),
            "m.yaml:2:13: 'x' found: expected resolution, a number");
  EXPECT_EQ(refusal("image: m.pgm\nresolution: 0.1\n"), "m.yaml:3:1: file ends without 'origin'");
  EXPECT_EQ(refusal("image: [\n"), "m.yaml:2:1: end of sequence flow not found");
  folder.write("m.pgm", "GIF89a");
  EXPECT_EQ(refusal("image: m.pgm\nresolution: 0.1\norigin: [0, 0, 0]\n"),
            "m.pgm: no picture that a map can have: expected PGM, PNG or BMP");
}

}  // namespace
}  // namespace eyebridge::files
