#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"
#include "eyebridge/world/world.hpp"
#include "fan.hpp"
#include "geometry.hpp"
#include "instruction_sets.hpp"
#include "near_walls.hpp"
#include "ray_scenes.hpp"
#include "scenes.hpp"

namespace eyebridge::world {
namespace {

TEST(Fans, TogetherMeetTheSameDiscsInEveryInstructionSet) {
  Random random(100);
  // Few, some, and so many that the list of one fan is full more than once.
  for (const std::size_t count : {std::size_t{9}, std::size_t{200}, std::size_t{6000}}) {
    const Crowd crowd(count, random, count > 1000 ? 0.01 : 0.05);
    for (int round = 0; round < 10; ++round) {
      std::vector<Rays> rays;
      std::vector<BodyId> selves;
      for (std::size_t i = 0; i < kFansTogether; ++i) {
        selves.push_back(static_cast<BodyId>(random.bits() % count));
        const auto some = static_cast<int>(1 + random.bits() % Fan::kMost);
        rays.push_back(
            fan(crowd.bodies.position(selves[i]), 7 * random.uniform(), 2 * kPi / some, some));
      }
      const auto fans = [&] {
        std::vector<Fan> made;
        for (std::size_t i = 0; i < rays.size(); ++i) {
          const RayFan asked{rays[i].origin, rays[i].directions, 5.0, selves[i], {}};
          made.emplace_back(asked, crowd.map.place_of(selves[i]));
        }
        return made;
      };
      const auto check = [&](std::vector<Fan>& made, const std::string& which) {
        for (std::size_t i = 0; i < rays.size(); ++i) {
          for (std::size_t k = 0; k < rays[i].directions.size(); ++k) {
            double expected = 5.0;
            for (BodyId id = 0; id < count; ++id) {
              if (id == selves[i]) continue;
              expected = nearer_disc_hit(crowd.bodies.position(id), crowd.bodies.radius_[id],
                                         rays[i].origin, rays[i].directions[k], expected);
            }
            ASSERT_EQ(made[i].ranges()[k], expected) << which << ", " << count << ", fan " << i;
          }
        }
      };
      in_every_instruction_set([&](const std::string& name) {
        std::vector<Fan> made = fans();
        Fan::meet_discs(made, crowd.map, crowd.bodies.largest_radius());
        check(made, name);
      });
    }
  }
}

TEST(Fans, AndSweepsMeetNobodyWhereNobodyIs) {
  const World world(shared(room(4, 4)));
  for (const int count : {1, 8, 40}) {
    const Rays rays = fan({1.0, 2.0}, 0.1, 2 * kPi / count, count);
    std::vector<double> ranges(rays.directions.size());
    const RayFan asked{rays.origin, rays.directions, 0.5, kNoBody, ranges};
    world.cast_fans({&asked, 1});
    EXPECT_EQ(ranges, std::vector(ranges.size(), 0.5));
    world.cast_sweep(rays.origin, rays.directions, rays.gap, 0.25, kNoBody, ranges);
    EXPECT_EQ(ranges, std::vector(ranges.size(), 0.25));
  }
}

/// What a loop over all `walls` finds.
double range_to_walls(const std::vector<Segment>& walls, Vec2 origin, Vec2 direction,
                      double max_range) {
  double range = max_range;
  for (const Segment& s : walls) range = nearer_hit(s, origin, direction, range);
  return range;
}

/// What a loop over all `walls` and bodies finds.
double range_by_loop(const World& world, const std::vector<Segment>& walls, Vec2 origin,
                     Vec2 direction, double max_range, BodyId ignore) {
  double range = range_to_walls(walls, origin, direction, max_range);
  for (BodyId id = 0; id < world.body_count(); ++id) {
    if (id == ignore) continue;
    range = nearer_disc_hit(world.position(id), world.radius(id), origin, direction, range);
  }
  return range;
}

/// Many fans of World::cast_fans(), and what they lend it.
struct ManyFans {
  std::vector<Rays> rays;
  std::vector<std::vector<Vec2>> origins;
  std::vector<std::vector<double>> ranges;
  std::vector<RayFan> fans;

  /// From the places of bodies; of 1 up to `most` rays each. Half of them begin at places of their
  /// own, up to `spread` metres from there: outward on a circle, next to that, or anywhere.
  ManyFans(const World& world, std::size_t count, std::size_t most, double spread, Random& random) {
    for (std::size_t i = 0; i < count; ++i) {
      const auto id = static_cast<BodyId>(random.bits() % world.body_count());
      const auto some = static_cast<int>(1 + random.bits() % most);
      const double gap = 2 * kPi / (random.chance(0.5) ? some : 20);
      rays.push_back(fan(world.position(id) + Vec2{0.001 * random.uniform(), 0.0},
                         7 * random.uniform(), gap, some));
      ranges.emplace_back(rays.back().directions.size(), -1.0);
      // No more of them than lists of walls are kept for.
      const double reach = std::vector<double>{
          0.2, 1.5, 6.0, std::numeric_limits<double>::infinity()}[random.bits() % 4];
      fans.push_back({rays.back().origin, {}, reach, random.chance(0.9) ? id : kNoBody, {}});
      origins.emplace_back();
      if (random.chance(0.5)) continue;
      const double kind = random.uniform();
      for (const Vec2 direction : rays.back().directions) {
        const Vec2 left{-direction.y, direction.x};
        Vec2 from = direction;
        if (kind > 0.4) from = 0.9 * direction + 0.05 * left;
        if (kind > 0.7)
          from = random.uniform() * Heading::from_angle(7 * random.uniform()).forward();
        origins.back().push_back(rays.back().origin + spread * from);
      }
      fans.back().spread = spread;
    }
    for (std::size_t i = 0; i < count; ++i) {
      fans[i].directions = rays[i].directions;
      fans[i].origins = origins[i];
      fans[i].ranges = ranges[i];
    }
  }
};

Vec2 origin_of(const RayFan& fan, std::size_t ray) {
  return fan.origins.empty() ? fan.origin : fan.origins[ray];
}

void expect_ranges_of_a_loop(unsigned bodies, double spread) {
  World world(shared(random_walls(96, 30, 6.0, 0.05)));
  const std::vector<Segment> walls = outlines_of(world.model().walls);
  Random random(97);
  while (world.body_count() < bodies) {
    const Pose pose{6 * random.uniform(), 6 * random.uniform(), 0};
    const double radius = 0.01 + 0.02 * random.uniform();
    if (world.is_free(pose.position(), radius)) world.add_robot(pose, radius, 0.1, {});
  }
  int by_bodies = 0;
  int inside = 0;
  const int rounds = bodies > 1000 ? 4 : 16;
  for (int round = 0; round < rounds; ++round) {
    world.set_pose(static_cast<BodyId>(round % 9), {7 * random.uniform(), random.uniform(), 0});
    // Each fourth one also has some that are cast alone.
    const std::size_t most =
        std::vector<std::size_t>{8, 16, 16, 20}[static_cast<std::size_t>(round % 4)];
    const ManyFans many(world, 1 + random.bits() % 40, most, spread, random);
    world.cast_fans(many.fans);
    for (const RayFan& each : many.fans) {
      for (std::size_t k = 0; k < each.directions.size(); ++k) {
        const Vec2 origin = origin_of(each, k);
        const double expected =
            range_by_loop(world, walls, origin, each.directions[k], each.max_range, each.ignore);
        ASSERT_EQ(each.ranges[k], expected)
            << bodies << " bodies, spread " << spread << ", round " << round << ", ray " << k;
        const double wall = range_to_walls(walls, origin, each.directions[k], each.max_range);
        by_bodies += expected < wall ? 1 : 0;
        inside += expected == 0.0 && !each.origins.empty() ? 1 : 0;
      }
    }
  }
  EXPECT_GT(by_bodies, 100) << bodies << " bodies";
  if (bodies > 1000) {
    EXPECT_GT(inside, 10) << "rays that begin in others";
  }
}

TEST(Fans, TogetherGiveExactlyTheRangesOfALoopOverAllWallsAndBodies) {
  for (const unsigned bodies : {9U, 60U}) {
    // The last one is too much for a fan.
    for (const double spread : {0.02, 0.1, 0.5, 3.0}) expect_ranges_of_a_loop(bodies, spread);
  }
  expect_ranges_of_a_loop(3000U, 0.1);
}

TEST(Fans, TakeRaysForOneLineOnlyWhereAllOfThemAre) {
  // Four rays, of which the second half look the other way. All walls are beside the origin.
  const std::vector<Segment> segments{{{-0.1, 1.0}, {1.0, 0.0}, 0.2},
                                      {{0.2, -1.0}, {1.0, 0.0}, 0.2},
                                      {{1.0, -0.1}, {0.0, 1.0}, 0.2},
                                      {{-1.0, -0.1}, {0.0, 1.0}, 0.2}};
  const NearWalls near(segments);
  const std::vector<Vec2> directions{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  for (std::size_t off = 0; off < 4; ++off) {
    std::vector<Vec2> origins(4);
    origins[off] = 0.3 * Vec2{std::fabs(directions[off].y), std::fabs(directions[off].x)};
    const RayFan rays{{}, directions, 5.0, kNoBody, {}, origins, 0.3};
    const WallList all = *near.around({}, Fan::reach_of(rays));
    in_every_instruction_set([&](const std::string& name) {
      Fan fan(rays, BodyMap::kNowhere);
      fan.meet_walls(segments.data(), all);
      for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_EQ(fan.ranges()[k], range_to_walls(segments, origins[k], directions[k], 5.0))
            << name << ", ray " << k << " where ray " << off << " is off";
      }
    });
  }
}

TEST(Fans, OfManySpreadsAskForFewReaches) {
  const std::vector<Vec2> origins(8);
  std::vector<double> reaches;
  for (double spread = 1e-9; spread <= Fan::kMostSpread; spread *= 1.1) {
    const RayFan rays{{}, {}, 4.0, kNoBody, {}, origins, spread};
    ASSERT_GE(Fan::reach_of(rays), 4.0 + spread);
    reaches.push_back(Fan::reach_of(rays));
  }
  EXPECT_LE(std::unique(reaches.begin(), reaches.end()) - reaches.begin(), 6);
  EXPECT_EQ(Fan::reach_of({{}, {}, 4.0, kNoBody, {}}), 4.0);
}

TEST(Fans, AmongThingsWithCornersAreCastToo) {
  WorldModel model = random_walls(98, 10, 6.0, 0.05);
  ObjectSpec box;
  box.kind = ObjectKind::Box;
  box.size = {0.4, 0.2};
  box.pose = {3.0, 3.0, 0.0};
  model.objects.push_back(box);
  World world(shared(model));
  Random random(99);
  while (world.body_count() < 30) {
    const Pose pose{6 * random.uniform(), 6 * random.uniform(), 0};
    if (world.is_free(pose.position(), 0.03)) world.add_robot(pose, 0.03, 0.1, {});
  }
  const ManyFans many(world, 30, 8, 0.2, random);
  world.cast_fans(many.fans);
  for (const RayFan& each : many.fans) {
    for (std::size_t k = 0; k < each.ranges.size(); ++k) {
      ASSERT_EQ(each.ranges[k], world.cast_ray(origin_of(each, k), each.directions[k],
                                               each.max_range, each.ignore));
    }
  }
}

}  // namespace
}  // namespace eyebridge::world
