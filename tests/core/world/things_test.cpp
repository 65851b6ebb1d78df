#include <span>
#include <string>

#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"
#include "eyebridge/world/world.hpp"
#include "overlap.hpp"
#include "scenes.hpp"
#include "trail.hpp"

namespace eyebridge::world {
namespace {

constexpr double kThingsStep = 0.01;

/// Robots among balls, cans and boxes of every behaviour, and obstacles on paths, in a room with
/// some walls at any angle.
World fair(int robots, std::uint64_t seed) {
  Random random(seed);
  WorldModel model = random_walls(seed, 12, 3.0, 0.05);
  World trial(shared(model));
  const auto place = [&](double radius) {
    Vec2 p;
    do {
      p = {3 * random.uniform(), 3 * random.uniform()};
    } while (!trial.is_free(p, radius));
    trial.add_robot({p.x, p.y, 0}, radius, 0.1, {});  // keeps the place
    return Pose{p.x, p.y, 2 * kPi * random.uniform()};
  };
  for (int i = 0; i < 30; ++i) {
    ObjectSpec spec;
    spec.kind = static_cast<ObjectKind>(i % 4);
    spec.radius = 0.03;
    spec.size = {0.06 + 0.1 * random.uniform(), 0.04 + 0.05 * random.uniform()};
    const double length = 0.04 + 0.06 * random.uniform();
    spec.corners = {{length, 0.0}, {0.01, 0.04}, {-0.03, 0.0}, {0.0, -0.05}};
    spec.pose = place(spec.outer_radius());
    spec.matter.mass = 0.05 + random.uniform();
    if (i % 4 == 0) spec.matter.friction = 0.1 * random.uniform();
    if (i % 5 == 0) spec.matter.restitution = random.uniform();
    spec.matter.fixed = i % 7 == 0;
    if (i % 10 == 2) spec.path = Path{0.3, i > 20, {{1, 1}, {2, 1.5}, {1.5, 2.5}}};
    model.objects.push_back(spec);
  }
  World world(shared(model));
  for (int i = 0; i < robots; ++i) {
    const double radius = 0.03 + 0.04 * random.uniform();
    world.add_robot(place(radius), radius, 0.1, {});
  }
  return world;
}

void stroll(World& world, Random& random) {
  for (auto robot = static_cast<BodyId>(world.object_count()); robot < world.body_count();
       ++robot) {
    Arc arc{{0.012 * random.uniform(), 0.0}, {}};
    if (random.chance(0.1)) arc.turn = Heading::from_angle(2 * random.uniform() - 1);
    if (random.chance(0.05)) arc.displacement.x = -0.03;
    world.move(robot, arc, kThingsStep);
  }
  world.step_objects(kThingsStep);
}

TEST(Things, OfEveryKindNeverStandInEachOther) {
  World world = fair(12, 31);
  Random random(32);
  const std::vector<Vec2> before = [&] {
    std::vector<Vec2> places;
    for (BodyId id = 0; id < world.body_count(); ++id) places.push_back(world.position(id));
    return places;
  }();
  ASSERT_EQ(deepest_of_all(world), 0.0);
  for (int step = 0; step < 4000; ++step) {
    stroll(world, random);
    if (step % 10 == 0) {
      ASSERT_EQ(deepest_of_all(world), 0.0) << "step " << step;
    }
  }
  int moved = 0;
  for (BodyId id = 0; id < world.body_count(); ++id) {
    const bool fixed = id < world.object_count() && world.model().objects[id].matter.fixed &&
                       !world.model().objects[id].path;
    if (fixed) {
      EXPECT_EQ(world.position(id), before[id]) << id;
    }
    moved += world.position(id) == before[id] ? 0 : 1;
  }
  EXPECT_GT(moved, 25);
}

TEST(Things, RaysMeetTheNearestOfThem) {
  const World world = fair(5, 41);
  const RayCaster walls(world.model());
  Random random(42);
  int met = 0;
  for (int i = 0; i < 400; ++i) {
    const Vec2 origin{3 * random.uniform(), 3 * random.uniform()};
    const std::vector<Vec2> directions = directions_around(36);
    std::vector<double> sweep(36);
    std::vector<double> fan(12);
    world.cast_sweep(origin, directions, 2 * kPi / 36, 5.0, kNoBody, sweep);
    world.cast_fan(origin, std::span(directions).first(12), 5.0, kNoBody, fan);
    for (std::size_t k = 0; k < directions.size(); ++k) {
      const Vec2 direction = directions[k];
      double expected = walls.cast(origin, direction, 5.0);
      const double wall = expected;
      for (BodyId id = 0; id < world.body_count(); ++id) {
        expected = is_convex(world, id)
                       ? nearer_convex_hit(convex_at(world, id), origin, direction, expected)
                       : nearer_disc_hit(world.position(id), world.radius(id), origin, direction,
                                         expected);
      }
      ASSERT_EQ(world.cast_ray(origin, direction, 5.0, kNoBody), expected);
      ASSERT_EQ(sweep[k], expected);
      if (k < fan.size()) {
        ASSERT_EQ(fan[k], expected);
      }
      met += expected < wall ? 1 : 0;
    }
  }
  EXPECT_GT(met, 1000);
}

struct Fair {
  std::uint64_t hash = 0;  ///< Of bodies and bumps.
  std::string trail;       ///< Of the first robot: its place, and how many bumps there were.
};

Fair fixed_fair() {
  Fair fair_day;
  std::size_t bumps = 0;
  World world = fair(12, 51);
  Random random(52);
  StateHash hash;
  for (int step = 0; step < 1500; ++step) {
    stroll(world, random);
    for (const Bump& bump : world.bumps()) {
      hash.add(std::uint64_t{bump.body});
      hash.add(std::uint64_t{bump.other});
    }
    bumps += world.bumps().size();
    if (step % 50 == 0) world.add_to(hash);
    if (step % 300 != 0) continue;
    const Vec2 place = world.position(static_cast<BodyId>(world.object_count()));
    fair_day.trail += trail_line(step, place.x, place.y, bumps);
  }
  fair_day.hash = hash.value();
  return fair_day;
}

// In debug and release, on every CPU: a change here is a change of behaviour.
TEST(Things, MoveTheSameWayEachTimeAndInEveryBuild) {
  const Fair fair_day = fixed_fair();
  EXPECT_EQ(fair_day.hash, fixed_fair().hash);
  EXPECT_EQ(fair_day.trail,
            "0: 1.7982086604247305 1.2719221829389498 0\n"
            "300: 1.705771831962785 1.5399721471798211 70\n"
            "600: 2.396080973501998 1.7047857474472157 167\n"
            "900: 2.2607560967372278 1.9105634465895578 240\n"
            "1200: 2.2348577650688055 1.952644055634506 348\n");
}

}  // namespace
}  // namespace eyebridge::world
