#include "sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"
#include "eyebridge/world/world.hpp"
#include "fan.hpp"
#include "geometry.hpp"
#include "instruction_sets.hpp"
#include "near_walls.hpp"
#include "ray_scenes.hpp"
#include "scenes.hpp"
#include "standing_walls.hpp"

namespace eyebridge::world {
namespace {

/// Fans of all kinds: round and not, either way, with rays right through ends of walls and from
/// places upon and next to them.
Rays random_fan(const std::vector<Segment>& segments, double size, Random& random) {
  Vec2 origin{(size + 1) * random.uniform() - 0.5, (size + 1) * random.uniform() - 0.5};
  const Segment& one = segments[random.bits() % segments.size()];
  const double kind = random.uniform();
  if (kind < 0.1) origin = one.a;
  if (kind >= 0.1 && kind < 0.2) origin = one.a + 0.3 * one.length * one.u;
  if (kind >= 0.2 && kind < 0.3) origin = one.a + Vec2{1e-4 * random.uniform(), -3e-4};
  double start = 2 * kPi * random.uniform();
  if (random.chance(0.5)) {
    const Vec2 to = segments[random.bits() % segments.size()].a - origin;
    if (norm(to) > 0.0) start = arc_tan2(to.y, to.x);
  }
  const int count = std::vector<int>{2, 5, 8, 8, 16, 17, 90, 360, 360, 1000}[random.bits() % 10];
  const double turn = random.chance(0.5) ? 2 * kPi : 2 * kPi * random.uniform();
  return fan(origin, start, (random.chance(0.5) ? 1 : -1) * turn / count, count);
}

TEST(Sweep, GivesExactlyTheRangesOfALoopOverAllWallsAndBodies) {
  for (const double thickness : {0.0, 0.08}) {
    World world(shared(random_walls(90, 60, 4.0, thickness)));
    const std::vector<Segment> segments = outlines_of(world.model().walls);
    Random random(91);
    while (world.body_count() < 40) {
      const Pose pose{4 * random.uniform(), 4 * random.uniform(), 0};
      const double radius = 0.02 + 0.05 * random.uniform();
      if (world.is_free(pose.position(), radius)) world.add_robot(pose, radius, 0.1, {});
    }
    int by_walls = 0;
    int by_bodies = 0;
    std::vector<double> ranges;
    for (int i = 0; i < 3000; ++i) {
      // Bodies move between the looks, one of them out of the room.
      world.set_pose(static_cast<BodyId>(i % 40), {5 * random.uniform(), 4 * random.uniform(), 0});
      Rays rays = random_fan(segments, 4.0, random);
      if (i % 10 == 0) rays.origin = world.position(3) + Vec2{world.radius(3) * 0.9, 0};
      const double max_range = std::vector<double>{
          0.3, 2.5, 8.0, std::numeric_limits<double>::infinity()}[static_cast<std::size_t>(i % 4)];
      const BodyId ignore = i % 3 == 0 ? kNoBody : static_cast<BodyId>(random.bits() % 40);
      ranges.assign(rays.directions.size(), -1.0);
      if (rays.directions.size() <= Fan::kMost) {
        world.cast_fan(rays.origin, rays.directions, max_range, ignore, ranges);
      } else {
        world.cast_sweep(rays.origin, rays.directions, rays.gap, max_range, ignore, ranges);
      }
      for (std::size_t k = 0; k < ranges.size(); ++k) {
        double wall = max_range;
        for (const Segment& s : segments) {
          wall = nearer_hit(s, rays.origin, rays.directions[k], wall);
        }
        double expected = wall;
        for (BodyId id = 0; id < world.body_count(); ++id) {
          if (id == ignore) continue;
          expected = nearer_disc_hit(world.position(id), world.radius(id), rays.origin,
                                     rays.directions[k], expected);
        }
        ASSERT_EQ(ranges[k], expected) << "fan " << i << ", ray " << k;
        by_bodies += expected < wall ? 1 : 0;
        by_walls += wall < max_range ? 1 : 0;
      }
    }
    EXPECT_GT(by_walls, 50000);
    EXPECT_GT(by_bodies, 5000);
  }
}

/// What a loop over all walls and discs gives.
double expected_range(const World& world, const std::vector<Segment>& segments, Vec2 origin,
                      Vec2 direction, double max_range, BodyId ignore) {
  double range = max_range;
  for (const Segment& s : segments) range = nearer_hit(s, origin, direction, range);
  for (BodyId id = 0; id < world.body_count(); ++id) {
    if (id == ignore || !world.is_there(id) || world.shape(id) == BodyShape::Polygon) continue;
    range = nearer_disc_hit(world.position(id), world.radius(id), origin, direction, range);
  }
  return range;
}

TEST(Sweep, FindsEachOfACrowdAndNoneThatHasLeft) {
  World world(shared(random_walls(96, 30, 6.0, 0.08)));
  const std::vector<Segment> segments = outlines_of(world.model().walls);
  Random random(97);
  // Most of them in a corner: long runs of the map beside empty ones.
  for (int i = 0; i < 60000 && world.body_count() < 1500; ++i) {
    const double size = i % 4 == 0 ? 6.0 : 2.0;
    const Pose pose{size * random.uniform(), size * random.uniform(), 0};
    if (world.is_free(pose.position(), 0.015)) world.add_robot(pose, 0.015, 0.1, {});
  }
  ASSERT_GT(world.body_count(), 1200U);
  std::vector<double> ranges;
  for (int i = 0; i < 100; ++i) {
    const auto left = static_cast<BodyId>(5U * static_cast<unsigned>(i) % world.body_count());
    if (i > 30 && world.is_there(left)) world.remove(left);
    const Rays rays = random_fan(segments, 6.0, random);
    // Also one that has left may be ignored.
    const BodyId ignore = i % 3 == 0 ? left : static_cast<BodyId>(i);
    ranges.assign(rays.directions.size(), -1.0);
    world.cast_sweep(rays.origin, rays.directions, rays.gap, 5.0, ignore, ranges);
    for (std::size_t k = 0; k < ranges.size(); ++k) {
      ASSERT_EQ(ranges[k],
                expected_range(world, segments, rays.origin, rays.directions[k], 5.0, ignore))
          << "fan " << i << ", ray " << k;
    }
  }
}

TEST(Sweep, AmongBoxesAndPolygonsGivesExactlyTheRangesOfSingleRays) {
  WorldModel model = random_walls(98, 20, 6.0, 0.08);
  Random random(99);
  for (int i = 0; i < 120; ++i) {
    ObjectSpec object;
    object.pose = {6.0 * random.uniform(), 6.0 * random.uniform(), 6.0 * random.uniform()};
    if (i % 3 == 0) {
      object.kind = ObjectKind::Polygon;
      object.corners = {{0.1, 0.0}, {-0.05, 0.08}, {-0.1, -0.1}};
    } else if (i % 3 == 1) {
      object.kind = ObjectKind::Box;
      object.size = {0.02 + 0.4 * random.uniform(), 0.02 + 0.1 * random.uniform()};
    } else {
      object.radius = 0.02 + 0.05 * random.uniform();
    }
    model.objects.push_back(object);
  }
  World world(shared(model));
  const std::vector<Segment> segments = outlines_of(world.model().walls);
  std::vector<double> ranges;
  int by_corners = 0;
  int inside = 0;
  for (int i = 0; i < 300; ++i) {
    const auto moved = static_cast<BodyId>(i % 120);
    if (i % 7 == 0) world.set_pose(moved, {6.0 * random.uniform(), 6.0 * random.uniform(), 1.0});
    if (i > 200) world.remove(moved);
    const Rays rays = random_fan(segments, 6.0, random);
    const auto ignore = static_cast<BodyId>(i % 130);
    ranges.assign(rays.directions.size(), -1.0);
    world.cast_sweep(rays.origin, rays.directions, rays.gap, 5.0, ignore, ranges);
    for (std::size_t k = 0; k < ranges.size(); ++k) {
      ASSERT_EQ(ranges[k], world.cast_ray(rays.origin, rays.directions[k], 5.0, ignore))
          << "fan " << i << ", ray " << k;
      const double others =
          expected_range(world, segments, rays.origin, rays.directions[k], 5.0, ignore);
      by_corners += ranges[k] < others ? 1 : 0;
      inside += ranges[k] == 0.0 && others > 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(by_corners, 1000);
  EXPECT_GT(inside, 100) << "rays that begin in one";
}

TEST(Sweep, EveryInstructionSetGivesTheSameBits) {
  const std::vector<Segment> segments = outlines_of(random_walls(92, 80, 4.0, 0.08).walls);
  NearWalls near(segments, 1000);
  Random random(93);
  for (int i = 0; i < 400; ++i) {
    const Rays rays = random_fan(segments, 4.0, random);
    if (rays.directions.size() > Sweep::kMost) continue;
    Crowd crowd(i % 2 == 0 ? 5 : 60, random);
    const WallList all = *near.around({2.0, 2.0}, 10.0);
    const double largest = crowd.bodies.largest_radius();
    const BodyId ignore = 3;
    const auto expected = [&](std::size_t k) {
      double range = 5.0;
      for (const Segment& s : segments) {
        range = nearer_hit(s, rays.origin, rays.directions[k], range);
      }
      for (BodyId id = 0; id < crowd.bodies.size(); ++id) {
        if (id == ignore) continue;
        range = nearer_disc_hit(crowd.bodies.position(id), crowd.bodies.radius_[id], rays.origin,
                                rays.directions[k], range);
      }
      return range;
    };
    const auto check = [&](std::span<const double> ranges, const std::string& which) {
      for (std::size_t k = 0; k < ranges.size(); ++k) {
        ASSERT_EQ(ranges[k], expected(k)) << which << ", fan " << i << ", ray " << k;
      }
    };
    in_every_instruction_set([&](const std::string& name) {
      Sweep one_by_one(rays.origin, rays.directions, rays.gap, 5.0);
      one_by_one.meet_walls(segments.data(), all);
      one_by_one.meet_discs(crowd.map.around(rays.origin, 10.0), ignore);
      check(one_by_one.ranges(), name + ", disc by disc");
      {
        const BodyMap::Hidden hidden(crowd.map, ignore);
        Sweep sweep(rays.origin, rays.directions, rays.gap, 5.0);
        sweep.meet_walls(segments.data(), all);
        sweep.meet_discs(crowd.map, largest);
        check(sweep.ranges(), name + ", sweep");
      }
      if (rays.directions.size() > Fan::kMost) return;
      Fan few({rays.origin, rays.directions, 5.0, ignore, {}}, crowd.map.place_of(ignore));
      few.meet_walls(segments.data(), all);
      Fan::meet_discs({&few, 1}, crowd.map, largest);
      check(few.ranges(), name + ", fan");
    });
  }
}

TEST(Sweep, RaysAlongWallsMeetTheirNearerEnds) {
  // A chequered floor of walls with gaps between them, and places upon their lines.
  std::vector<Segment> segments;
  for (int column = 0; column < 12; ++column) {
    for (int row = 0; row < 12; ++row) {
      const Vec2 corner{0.5 * column, 0.5 * row};
      segments.push_back({corner, {1.0, 0.0}, 0.3});
      segments.push_back({corner + Vec2{0.0, 0.1}, {0.0, 1.0}, 0.3});
    }
  }
  NearWalls near(segments, 1000);
  const WallList all = *near.around({3.0, 3.0}, 20.0);
  ASSERT_EQ(all.indices.size(), 288U) << "more than a sweep takes at once";
  int along = 0;
  for (int i = 0; i < 24; ++i) {
    const Vec2 origin{0.5 * (i % 7) + 0.4, 0.5 * (i % 11)};
    const double turn = (i % 2 == 0 ? 2 : -2) * kPi / 360;
    const Rays rays = fan(origin, i % 4 * kPi / 2, turn, 360);
    in_every_instruction_set([&](const std::string& name) {
      Sweep sweep(origin, rays.directions, turn, 8.0);
      sweep.meet_walls(segments.data(), all);
      for (std::size_t k = 0; k < rays.directions.size(); ++k) {
        double across = 8.0;  // without those that the ray runs along
        double expected = 8.0;
        for (const Segment& wall : segments) {
          const bool parallel = std::fabs(cross(rays.directions[k], wall.u)) < kParallel;
          expected = nearer_hit(wall, origin, rays.directions[k], expected);
          if (!parallel) across = nearer_hit(wall, origin, rays.directions[k], across);
        }
        ASSERT_EQ(sweep.ranges()[k], expected) << "fan " << i << ", ray " << k << ", " << name;
        along += expected < across ? 1 : 0;
      }
    });
  }
  EXPECT_GT(along, 20);
}

TEST(Sweep, ItsFirstRayMeetsTheEndOfTheFirstWallThatItRunsAlong) {
  // What a sweep lists first: one wall before it and one behind it, and nothing but those.
  const std::vector<Segment> segments{{{1.0, 0.0}, {1.0, 0.0}, 0.5},
                                      {{-2.5, 0.0}, {1.0, 0.0}, 0.5}};
  const NearWalls near(segments, 1000);
  const WallList both = *near.around({0.0, 0.0}, 8.0);
  for (const double gap : {2 * kPi / 40, -2 * kPi / 40}) {
    const Rays rays = fan({0.0, 0.0}, 0.0, gap, 40);
    std::vector<double> expected(40, 8.0);
    expected[0] = 1.0;
    expected[20] = 2.0;
    in_every_instruction_set([&](const std::string& name) {
      Sweep sweep(rays.origin, rays.directions, gap, 8.0);
      sweep.meet_walls(segments.data(), both);
      const std::span<const double> ranges = sweep.ranges();
      EXPECT_EQ(std::vector<double>(ranges.begin(), ranges.end()), expected) << name;
    });
  }
}

TEST(NearWalls, ListsEveryWallInReachOnceAndGivesUpWhereThereAreMany) {
  const std::vector<Segment> segments = outlines_of(random_walls(94, 150, 5.0, 0.08).walls);
  NearWalls near(segments);
  Random random(95);
  int listed = 0;
  int given_up = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec2 p{5 * random.uniform(), 5 * random.uniform()};
    const double reach = std::vector<double>{0.2, 1.0, 5.0}[static_cast<std::size_t>(i % 3)];
    const auto list = near.around(p, reach);
    if (!list) {
      ++given_up;
      EXPECT_GT(reach, 1.0);
      continue;
    }
    ++listed;
    for (std::size_t k = 1; k < list->indices.size(); ++k) {
      ASSERT_LT(list->indices[k - 1], list->indices[k]);
    }
    for (std::uint32_t s = 0; s < segments.size(); ++s) {
      if (norm(closest_point(segments[s], p) - p) > reach) continue;
      ASSERT_TRUE(std::find(list->indices.begin(), list->indices.end(), s) != list->indices.end())
          << i;
    }
  }
  EXPECT_GT(listed, 1000);
  EXPECT_GT(given_up, 500);
  EXPECT_FALSE(near.around({-1.0, 2.0}, 1.0)) << "outside";
}

TEST(NearWalls, GivesManyThreadsTheSameLists) {
  const std::vector<Segment> segments = outlines_of(random_walls(95, 60, 5.0, 0.08).walls);
  const NearWalls near(segments);
  std::vector<std::vector<std::uint32_t>> seen(4);
  {
    std::vector<std::jthread> threads;
    for (std::vector<std::uint32_t>& mine : seen) {
      threads.emplace_back([&] {
        Random random(96);
        for (int i = 0; i < 2000; ++i) {
          const Vec2 place{5 * random.uniform(), 5 * random.uniform()};
          const auto list = near.around(place, i % 2 == 0 ? 1.0 : 2.0);
          if (list) mine.insert(mine.end(), list->indices.begin(), list->indices.end());
        }
      });
    }
  }
  EXPECT_GT(seen[0].size(), 10000U);
  for (const auto& each : seen) EXPECT_EQ(each, seen[0]);
}

TEST(StandingWalls, AreSharedByTheWorldsOfAModelForAsLongAsThereAreSome) {
  const std::shared_ptr<const WorldModel> model = shared(random_walls(1, 5, 4.0, 0.05));
  const auto other = std::make_shared<const WorldModel>(*model);
  auto walls = StandingWalls::of(model);
  EXPECT_EQ(StandingWalls::of(model), walls);
  EXPECT_NE(StandingWalls::of(other), walls);
  const std::weak_ptr<const StandingWalls> gone = walls;
  walls = nullptr;
  EXPECT_TRUE(gone.expired());
  EXPECT_EQ(StandingWalls::of(model)->model, model);
}

}  // namespace
}  // namespace eyebridge::world
