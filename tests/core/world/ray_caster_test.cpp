#include "eyebridge/world/ray_caster.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"
#include "instruction_sets.hpp"
#include "process_memory.hpp"
#include "scenes.hpp"

namespace eyebridge::world {
namespace {

struct MethodCase {
  std::string name;
  RayMethod method;
  simd::InstructionSet instruction_set = simd::instruction_sets().front();

  friend void PrintTo(const MethodCase& c, std::ostream* out) { *out << c.name; }
};

/// Ranges of one method against those of the loop over all walls, from random places in and around
/// the world.
class EveryMethod : public ::testing::TestWithParam<MethodCase> {
 protected:
  const ChosenSet chosen_{GetParam().instruction_set};

  [[nodiscard]] static bool needs_maze() { return GetParam().method == RayMethod::EdgeBits; }

  static void expect_as_brute_force(const WorldModel& model, std::uint64_t seed, int places,
                                    double max_range) {
    const RayCaster reference(model, RayMethod::BruteForce);
    const RayCaster caster(model, GetParam().method);
    const double tolerance = needs_maze() ? 1e-12 : 0.0;
    Random random(seed);
    std::vector<Vec2> directions(64);
    std::vector<double> expected(directions.size());
    std::vector<double> actual(directions.size());
    for (int place = 0; place < places; ++place) {
      const Vec2 origin{(1.6 * random.uniform() - 0.3) * model.width,
                        (1.6 * random.uniform() - 0.3) * model.height};
      for (Vec2& d : directions) d = Heading::from_angle(2 * kPi * random.uniform()).forward();
      reference.cast_fan(origin, directions, max_range, expected);
      caster.cast_fan(origin, directions, max_range, actual);
      for (std::size_t i = 0; i < directions.size(); ++i) {
        if (actual[i] == expected[i]) continue;  // infinities too
        ASSERT_NEAR(actual[i], expected[i], tolerance)
            << "from (" << origin.x << ", " << origin.y << ") along (" << directions[i].x << ", "
            << directions[i].y << "), place " << place;
      }
    }
  }
};

class EveryGeneralMethod : public EveryMethod {};

TEST_P(EveryMethod, AgreesWithBruteForceInMazes) {
  for (const double density : {0.1, 0.4, 0.8}) {
    expect_as_brute_force(random_maze(7, 16, density), 11, 150, 5.0);
  }
  expect_as_brute_force(random_maze(8, 3, 0.3, 0.18), 12, 300, 50.0);
}

TEST_P(EveryGeneralMethod, AgreesWithBruteForceAmongWallsAtAnyAngle) {
  expect_as_brute_force(random_walls(1, 30, 4.0, 0.0), 13, 200, 10.0);
  expect_as_brute_force(random_walls(2, 400, 4.0, 0.05), 14, 200, 10.0);
  expect_as_brute_force(random_walls(3, 1000, 40.0, 0.2), 15, 150, 100.0);
}

TEST_P(EveryMethod, AgreesWithBruteForceForLongAndShortReach) {
  const WorldModel model = random_maze(9, 40, 0.02);
  expect_as_brute_force(model, 16, 60, 0.2);
  expect_as_brute_force(model, 17, 60, 1e6);
  expect_as_brute_force(model, 18, 60, std::numeric_limits<double>::infinity());
}

TEST_P(EveryMethod, AgreesWithBruteForceFromAndThroughGridPoints) {
  // Origins on walls and on the lines between cells, rays through corners and along walls.
  const WorldModel model = random_maze(10, 8, 0.4, 0.25);  // 0.25: exact in binary
  const RayCaster reference(model, RayMethod::BruteForce);
  const RayCaster caster(model, GetParam().method);
  for (int x = -3; x <= 35; ++x) {
    for (int y = -3; y <= 35; ++y) {
      const Vec2 origin{x * 0.0625, y * 0.0625};
      for (int dx = -5; dx <= 5; ++dx) {
        for (int dy = -5; dy <= 5; ++dy) {
          if (dx == 0 && dy == 0) continue;
          const double length = std::sqrt(static_cast<double>(dx * dx + dy * dy));
          const Vec2 d{dx / length, dy / length};
          ASSERT_NEAR(caster.cast(origin, d, 3.0), reference.cast(origin, d, 3.0), 1e-9)
              << origin.x << ' ' << origin.y << " along " << dx << ' ' << dy;
        }
      }
    }
  }
}

TEST_P(EveryMethod, NoRayLeavesAClosedRoomThroughItsCorners) {
  const WorldModel model = random_maze(1, 3, 0.0, 0.3);  // twelve walls around a square
  const RayCaster caster(model, GetParam().method);
  Random random(5);
  for (int i = 0; i < 3000; ++i) {
    const Vec2 origin{0.01 + 0.88 * random.uniform(), 0.01 + 0.88 * random.uniform()};
    const int k = i % 12;  // towards each of the joints
    const Vec2 joint{0.3 * (k < 4    ? k
                            : k < 6  ? 3
                            : k < 10 ? 9 - k
                                     : 0),
                     0.3 * (k < 4    ? 0
                            : k < 6  ? k - 3
                            : k < 10 ? 3
                                     : 12 - k)};
    const Vec2 way = joint - origin;
    const double distance = norm(way);
    const double range = caster.cast(origin, (1.0 / distance) * way, 10.0);
    ASSERT_NEAR(range, distance, 2e-8) << i;
  }
}

TEST_P(EveryMethod, NothingInReachReadsAsMaxRange) {
  const RayCaster caster(random_maze(1, 5, 0.0), GetParam().method);
  EXPECT_EQ(caster.cast({0.9, 0.9}, {1, 0}, 0.5), 0.5);
  EXPECT_EQ(caster.cast({-1, 0.9}, {-1, 0}, 7.0), 7.0);
  EXPECT_EQ(caster.cast({-1, -3.5}, {1, 0}, 7.0), 7.0);
  EXPECT_NEAR(caster.cast({-1, 0.9}, {1, -0.0}, 7.0), 1.0, 1e-15);
  EXPECT_EQ(caster.cast({1e9, 0.9}, {-1, 0.0}, 7.0), 7.0);
}

const auto name_of = [](const auto& row) { return row.param.name; };

/// Methods for any world, in every instruction set.
std::vector<MethodCase> general_methods() {
  std::vector<MethodCase> methods;
  for (const simd::InstructionSet set : simd::instruction_sets()) {
    methods.push_back({"Grid" + std::string(simd::name_of(set)), RayMethod::Grid, set});
  }
  return methods;
}

std::vector<MethodCase> all_methods() {
  std::vector<MethodCase> methods = general_methods();
  methods.push_back({"EdgeBits", RayMethod::EdgeBits});
  return methods;
}

INSTANTIATE_TEST_SUITE_P(RayCaster, EveryMethod, ::testing::ValuesIn(all_methods()), name_of);
INSTANTIATE_TEST_SUITE_P(RayCaster, EveryGeneralMethod, ::testing::ValuesIn(general_methods()),
                         name_of);

// So that the rows with AVX2 do not go away without a word.
TEST(RayCaster, Avx2IsUsedWhereLinuxFindsIt) {
  std::ifstream cpuinfo("/proc/cpuinfo");
  const std::string text(std::istreambuf_iterator<char>(cpuinfo), {});
  ASSERT_FALSE(text.empty());
#ifdef __x86_64__
  const bool has_avx2 = text.find(" avx2") != std::string::npos;
  EXPECT_EQ(simd::chosen_set() == simd::InstructionSet::Avx2, has_avx2);
  EXPECT_GE(simd::instruction_sets().size(), has_avx2 ? 3U : 1U);
#else
  EXPECT_EQ(simd::chosen_set(), simd::InstructionSet::Plain);
#endif
}

TEST(RayCaster, RangesAreTheClosedForm) {
  const RayCaster caster(room(4, 3), RayMethod::BruteForce);
  for (int i = -80; i <= 80; ++i) {
    const double angle = deg_to_rad(0.5 * i);
    const double expected = std::min(3.0 / std::cos(angle), 1.0 / std::fabs(std::sin(angle)));
    EXPECT_NEAR(caster.cast({1, 1}, Heading::from_angle(angle).forward(), 9),
                i > 0 ? std::min(3.0 / std::cos(angle), 2.0 / std::sin(angle)) : expected, 1e-14);
  }
}

TEST(RayCaster, ThickWallsAreSeenAtTheirFace) {
  WorldModel model = room(4, 4);
  Wall wall;
  wall.a = {2, 1};
  wall.b = {3, 2};
  wall.thickness = 0.2;
  model.walls.push_back(wall);
  const RayCaster caster(model);
  const double diagonal = std::sqrt(0.5);
  EXPECT_NEAR(caster.cast({2, 2}, {diagonal, -diagonal}, 9), diagonal - 0.1, 1e-14);
  EXPECT_NEAR(caster.cast({1.5, 0.5}, {diagonal, diagonal}, 9), diagonal, 1e-14) << "its end";
}

TEST(RayCaster, AFarCornerOfAWorldIsAsExactAsANearOne) {
  WorldModel model = random_walls(4, 2000, 900.0, 0.0);
  const RayCaster reference(model, RayMethod::BruteForce);
  const RayCaster caster(model, RayMethod::Grid);
  for (const Vec2 d : directions_around(720)) {
    ASSERT_EQ(caster.cast({899, 899}, d, 2000), reference.cast({899, 899}, d, 2000));
    ASSERT_EQ(caster.cast({-500, 450}, d, 4000), reference.cast({-500, 450}, d, 4000));
  }
}

/// Small heaps of walls far from each other, in a hall: most of the floor is empty.
WorldModel heaps_in_a_hall() {
  WorldModel model = room(1000, 800);
  Random random(41);
  for (int heap = 0; heap < 12; ++heap) {
    const Vec2 place{20 + 960 * random.uniform(), 20 + 760 * random.uniform()};
    for (int i = 0; i < 300; ++i) {
      Wall wall;
      wall.a = place + Vec2{10 * random.uniform(), 10 * random.uniform()};
      wall.b = wall.a + Vec2{40 * random.uniform(), 40 * random.uniform()};
      model.walls.push_back(wall);
    }
  }
  return model;
}

TEST_P(EveryGeneralMethod, AgreesWithBruteForceOverEmptyFloor) {
  const WorldModel model = heaps_in_a_hall();
  expect_as_brute_force(model, 42, 300, 2000.0);
  expect_as_brute_force(model, 43, 100, 90.0);
  // Along the axes and diagonals, from between cells, too, and from outside.
  const RayCaster reference(model, RayMethod::BruteForce);
  const RayCaster caster(model, GetParam().method);
  for (const Vec2 origin : {Vec2{500, 400}, Vec2{250, 100}, Vec2{0, 0}, Vec2{999.5, 0.5},
                            Vec2{-300, 400}, Vec2{1300, -200}, Vec2{500, 1e4}}) {
    for (const Vec2 d : directions_around(1440)) {
      ASSERT_EQ(caster.cast(origin, d, 5000), reference.cast(origin, d, 5000))
          << origin.x << ' ' << origin.y << " along " << d.x << ' ' << d.y;
    }
  }
}

/// Walls of 19 m that lie on one another, and some across.
WorldModel walls_on_one_another(int count) {
  WorldModel model;
  for (int i = 0; i < count; ++i) {
    const double off = 0.01 * (i % 7);
    const Vec2 end = i % 3 == 0   ? Vec2{19.5, 0.5 + off}
                     : i % 3 == 1 ? Vec2{0.5 + off, 19.5}
                                  : Vec2{19.5, 19.5 - off};
    model.walls.push_back({{0.5, 0.5}, end});
  }
  return model;
}

TEST_P(EveryGeneralMethod, AgreesWithBruteForceAmongWallsThatLieOnOneAnother) {
  expect_as_brute_force(walls_on_one_another(2000), 44, 40, 30.0);
}

TEST(RayCaster, ThousandsOfWallsOnOneAnotherTakeLittleMemory) {
  const WorldModel model = walls_on_one_another(20000);
  const std::size_t before = testing::resident_bytes();
  const RayCaster caster(model, RayMethod::Grid);
  EXPECT_LT(testing::resident_bytes() - before, 400U << 20U);  // 5,000 of them took 1.4 GB
  EXPECT_GT(caster.cast({10, 5}, {0, 1}, 30), 0.0);
}

TEST(RayCaster, TheGridGivesTheSameBitsInEveryInstructionSet) {
  const WorldModel model = random_walls(5, 700, 5.0, 0.03);
  const RayCaster caster(model);
  const std::vector<Vec2> directions = directions_around(360);
  std::vector<double> a(360);
  std::vector<double> b(360);
  Random random(6);
  for (int i = 0; i < 300; ++i) {
    const Vec2 origin{5 * random.uniform(), 5 * random.uniform()};
    caster.cast_fan(origin, directions, 3.0, a);
    in_every_instruction_set([&](const std::string& name) {
      caster.cast_fan(origin, directions, 3.0, b);
      ASSERT_EQ(a, b) << name;
    });
  }
}

TEST(RayCaster, FansOfAnySizeAndOrderReadAsEachRayAlone) {
  // Rays share registers with their neighbours, and walk in groups.
  const WorldModel model = random_walls(12, 300, 5.0, 0.03);
  const RayCaster reference(model, RayMethod::BruteForce);
  Random random(13);
  std::vector<Vec2> directions = directions_around(360);
  for (const bool shuffled : {false, true}) {
    if (shuffled) {
      for (std::size_t i = directions.size() - 1; i > 0; --i) {
        std::swap(directions[i], directions[random.bits() % (i + 1)]);
      }
    }
    in_every_instruction_set([&](const std::string& name) {
      const RayCaster caster(model, RayMethod::Grid);
      for (const std::size_t size : {1U, 2U, 3U, 4U, 5U, 7U, 127U, 128U, 129U, 131U, 360U}) {
        const Vec2 origin{7 * random.uniform() - 1, 7 * random.uniform() - 1};
        std::vector<double> ranges(size, -1.0);
        caster.cast_fan(origin, {directions.data(), size}, 4.0, ranges);
        for (std::size_t i = 0; i < size; ++i) {
          ASSERT_EQ(ranges[i], reference.cast(origin, directions[i], 4.0))
              << name << ", " << size << ": " << i;
        }
      }
    });
  }
}

TEST(RayCaster, AutoPicksEdgeBitsOnlyForPureMazes) {
  WorldModel model = random_maze(1, 4, 0.5);
  EXPECT_EQ(RayCaster(model).method(), RayMethod::EdgeBits);
  model.walls.front().thickness = 0.01;
  EXPECT_NE(RayCaster(model).method(), RayMethod::EdgeBits);
  EXPECT_THROW(RayCaster(model, RayMethod::EdgeBits), std::invalid_argument);
  EXPECT_EQ(RayCaster(room(1, 1)).method(), RayMethod::Grid);
}

TEST(RayCaster, AWorldWithoutWallsIsEndless) {
  for (const RayMethod method : {RayMethod::Auto, RayMethod::Grid, RayMethod::BruteForce}) {
    EXPECT_EQ(RayCaster(WorldModel{}, method).cast({1, 2}, {0, 1}, 8.0), 8.0);
  }
}

TEST(RayCaster, WallsOnOneLineMakeAGridToo) {
  WorldModel model;
  for (int i = 0; i < 50; ++i) {
    Wall wall;
    wall.a = {i * 0.1, 1.0};
    wall.b = {i * 0.1 + 0.05, 1.0};
    model.walls.push_back(wall);
  }
  const RayCaster caster(model, RayMethod::Grid);
  EXPECT_NEAR(caster.cast({0.32, 0}, {0, 1}, 8.0), 1.0, 1e-15);
  EXPECT_EQ(caster.cast({0.37, 0}, {0, 1}, 8.0), 8.0);
  EXPECT_NEAR(caster.cast({-1, 1}, {1, 0}, 8.0), 1.0, 1e-15) << "along the wall: its near end";
  EXPECT_EQ(caster.cast({0.32, 1}, {0.6, 0.8}, 8.0), 0.0) << "from a point on a wall";
}

}  // namespace
}  // namespace eyebridge::world
