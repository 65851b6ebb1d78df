#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"
#include "eyebridge/world/world.hpp"
#include "scenes.hpp"
#include "trail.hpp"
#include "wall_index.hpp"

namespace eyebridge::world {
namespace {

constexpr double kStep = 0.01;

/// `robots` robots, and balls and cans, at random free places of a maze.
World crowd(int robots, std::uint64_t seed) {
  WorldModel model = random_maze(seed, 9, 0.25);
  Random random(seed + 1);
  const auto place = [&] {
    return Vec2{random.uniform() * model.width, random.uniform() * model.height};
  };
  const World walls_only(shared(model));
  while (model.objects.size() < 20) {
    ObjectSpec spec;
    spec.kind = model.objects.size() % 2 == 0 ? ObjectKind::Ball : ObjectKind::Can;
    spec.pose = {place().x, place().y, 0};
    bool free = walls_only.is_free(spec.pose.position(), spec.radius);
    for (const ObjectSpec& other : model.objects) {
      free = free && norm(other.pose.position() - spec.pose.position()) > 0.05;
    }
    if (free) model.objects.push_back(spec);
  }
  World world(shared(model));
  while (world.body_count() < 20U + static_cast<unsigned>(robots)) {
    const Vec2 p = place();
    const double radius = 0.03 + 0.04 * random.uniform();
    if (!world.is_free(p, radius)) continue;
    world.add_robot({p.x, p.y, 2 * kPi * random.uniform()}, radius, 0.1, {});
  }
  return world;
}

/// One step of every robot: mostly ahead, at times in a curve, back or on the spot.
void wander(World& world, Random& random) {
  for (auto robot = static_cast<BodyId>(world.object_count()); robot < world.body_count();
       ++robot) {
    const double kind = random.uniform();
    Arc arc{{0.002 + 0.02 * random.uniform(), 0.0}, {}};
    if (kind < 0.1) arc = {{}, Heading::from_angle(2 * random.uniform() - 1)};
    if (kind > 0.7) arc.turn = Heading::from_angle(0.4 * random.uniform() - 0.2);
    if (kind > 0.95) arc.displacement.x = -0.05;
    world.move(robot, arc, kStep);
  }
  world.step_objects(kStep);
}

double deepest_overlap(const World& world, const std::vector<Segment>& walls) {
  double deepest = 0.0;
  for (BodyId id = 0; id < world.body_count(); ++id) {
    const Vec2 p = world.position(id);
    for (const Segment& wall : walls) {
      deepest = std::max(deepest, world.radius(id) - norm(p - closest_point(wall, p)));
    }
    for (BodyId other = 0; other < id; ++other) {
      deepest = std::max(deepest,
                         world.radius(id) + world.radius(other) - norm(p - world.position(other)));
    }
  }
  return deepest;
}

TEST(Invariants, NothingEverOverlapsInALongRandomWalkOfACrowd) {
  World world = crowd(50, 21);
  const std::vector<Segment> walls = outlines_of(world.model().walls);
  Random random(22);
  for (int step = 0; step < 3000; ++step) {
    wander(world, random);
    if (step % 10 == 0) {
      ASSERT_EQ(deepest_overlap(world, walls), 0.0) << "step " << step;
    }
  }
  for (BodyId id = 0; id < world.body_count(); ++id) {
    const Vec2 p = world.position(id);
    EXPECT_TRUE(p.x > 0 && p.x < world.model().width && p.y > 0 && p.y < world.model().height);
    EXPECT_NEAR(norm(world.heading(id).forward()), 1.0, 1e-15);
  }
}

TEST(Invariants, FewBodiesAndManyBodiesMoveBitForBitAlike) {
  // The same bodies, alone and with enough others far away to switch the grid of bodies on.
  WorldModel model = room(30, 30);
  World few(shared(model));
  World many(shared(model));
  for (int i = 0; i < 10; ++i) {
    const int row = i / 4;
    const Pose pose{1.0 + 0.25 * (i % 4), 1.0 + 0.25 * row, 0.7 * i};
    few.add_robot(pose, 0.1, 0.1, {});
    many.add_robot(pose, 0.1, 0.1, {});
  }
  for (int i = 0; i < 60; ++i) many.add_robot({20, 0.4 * i + 1, 0}, 0.1, 0.1, {});
  Random random(30);
  for (int step = 0; step < 3000; ++step) {
    const BodyId robot = static_cast<BodyId>(step % 10);
    const Arc arc{{0.05 * random.uniform() - 0.02, 0}, Heading::from_angle(random.uniform() - 0.5)};
    const MoveResult a = few.move(robot, arc, kStep);
    const MoveResult b = many.move(robot, arc, kStep);
    ASSERT_EQ(a.fraction, b.fraction);
    ASSERT_EQ(a.hit_body, b.hit_body);
    ASSERT_EQ(few.position(robot), many.position(robot));
    ASSERT_EQ(few.heading(robot), many.heading(robot));
  }
}

TEST(Invariants, RaysMeetTheSameBodiesAsALoopOverAll) {
  for (const int robots : {5, 300}) {  // without and with the grid of bodies
    World world(shared(room(12, 8)));
    Random random(80);
    while (world.body_count() < static_cast<unsigned>(robots)) {
      const Pose pose{12 * random.uniform(), 8 * random.uniform(), 0};
      const double radius = 0.02 + 0.06 * random.uniform();
      if (world.is_free(pose.position(), radius)) world.add_robot(pose, radius, 0.1, {});
    }
    // Put outside by a person; they belong to the rim of the grid.
    world.set_pose(0, {-3, 4, 0});
    world.set_pose(1, {14, -2, 0});
    const RayCaster walls(world.model());
    const std::vector<Vec2> around = directions_around(72);
    std::vector<double> fan(around.size());
    int met = 0;
    for (int i = 0; i < 300; ++i) {
      const Vec2 origin{16 * random.uniform() - 2, 12 * random.uniform() - 2};
      const BodyId ignore = static_cast<BodyId>(random.bits() % world.body_count());
      const double max_range = i % 3 == 0 ? std::numeric_limits<double>::infinity() : 0.1 * i;
      world.cast_fan(origin, around, max_range, ignore, fan);
      for (std::size_t k = 0; k < around.size(); ++k) {
        const double wall = walls.cast(origin, around[k], max_range);
        double expected = wall;
        for (BodyId id = 0; id < world.body_count(); ++id) {
          if (id == ignore) continue;
          expected =
              nearer_disc_hit(world.position(id), world.radius(id), origin, around[k], expected);
        }
        ASSERT_EQ(fan[k], expected);
        ASSERT_EQ(world.cast_ray(origin, around[k], max_range, ignore), expected);
        met += expected < wall ? 1 : 0;
      }
    }
    EXPECT_GT(met, 100);
  }
}

TEST(Invariants, RememberedClearanceChangesNothing) {
  // The World skips walls that are surely out of reach; here they are asked at every step.
  World world(shared(random_maze(40, 12, 0.3)));
  const WallIndex walls(world.model().walls);
  Random random(41);
  const double radius = 0.05;
  Vec2 start{0.18, 0.18};
  const BodyId robot = world.add_robot({start.x, start.y, 0.3}, radius, 0.1, {});
  int blocked = 0;
  for (int step = 0; step < 20000; ++step) {
    if (random.chance(0.1)) world.move(robot, {{}, Heading::from_angle(random.uniform())}, kStep);
    const Vec2 from = world.position(robot);
    const Vec2 motion = world.heading(robot).rotate({0.02 * random.uniform() + 1e-4, 0.0});
    const WallIndex::Approach asked =
        walls.approach(from, motion, norm(motion), radius + kContactGap, 1.0);
    const double expected = asked.fraction <= 1.0 ? asked.fraction : 1.0;
    const Heading back{world.heading(robot).cos, -world.heading(robot).sin};
    const MoveResult result = world.move(robot, {back.rotate(motion), {}}, kStep);
    ASSERT_EQ(result.blocked(), asked.fraction <= 1.0) << step;
    ASSERT_NEAR(result.fraction, expected, 1e-11) << step;  // the motion is rotated to and fro
    blocked += result.blocked() ? 1 : 0;
  }
  EXPECT_GT(blocked, 1000);
  EXPECT_LT(blocked, 19000);
}

TEST(Invariants, TheGridOfWallsFindsWhatALoopOverAllFinds) {
  for (const double thickness : {0.0, 0.08}) {
    const WorldModel model = random_walls(50, 300, 3.0, thickness);
    const WallIndex walls(model.walls);
    const std::vector<Segment>& segments = walls.segments();
    Random random(51);
    for (int i = 0; i < 3000; ++i) {
      const Vec2 p{4 * random.uniform() - 0.5, 4 * random.uniform() - 0.5};
      const Vec2 motion =
          0.3 * random.uniform() * Heading::from_angle(6.28 * random.uniform()).forward();
      double nearest = 0.8;
      double first = kNoContact;
      for (const Segment& s : segments) {
        nearest = std::min(nearest, norm(p - closest_point(s, p)));
        first = std::min(first, wall_contact(s, p, motion, 0.05));
      }
      ASSERT_EQ(walls.distance(p, 0.8), nearest);
      const WallIndex::Approach asked = walls.approach(p, motion, norm(motion), 0.05, 0.8);
      ASSERT_NEAR(asked.distance, nearest, 1e-15);
      if (!walls.inside_thick(p)) {
        ASSERT_EQ(asked.fraction, first);
      }
    }
  }
}

TEST(Invariants, JoinedWallsCoverExactlyTheOldOnes) {
  const WorldModel maze = random_maze(60, 10, 0.5);
  const std::vector<Wall> joined = join_collinear(maze.walls);
  EXPECT_LT(joined.size(), maze.walls.size() * 2 / 3);
  double before = 0.0;
  double after = 0.0;
  for (const Wall& wall : maze.walls) before += norm(wall.b - wall.a);
  for (const Wall& wall : joined) after += norm(wall.b - wall.a);
  EXPECT_NEAR(after, before, 1e-9);
  const std::vector<Wall> slanted = random_walls(61, 50, 3.0, 0.0).walls;
  EXPECT_EQ(join_collinear(slanted).size(), slanted.size()) << "walls that only cross stay apart";
}

struct FixedScene {
  std::uint64_t hash = 0;  ///< Of bodies and ranges.
  std::string trail;       ///< Of one body: its place, and its range ahead.
};

FixedScene fixed_scene() {
  FixedScene scene;
  World world = crowd(30, 70);
  Random random(71);
  StateHash hash;
  std::vector<Vec2> directions = directions_around(36);
  std::vector<double> ranges(directions.size());
  for (int step = 0; step < 1000; ++step) {
    wander(world, random);
    if (step % 50 != 0) continue;
    world.add_to(hash);
    world.cast_fan(world.position(25), directions, 4.0, 25, ranges);
    for (const double range : ranges) hash.add(range);
    if (step % 200 != 0) continue;
    const Vec2 place = world.position(25);
    scene.trail += trail_line(step, place.x, place.y, ranges[0]);
  }
  scene.hash = hash.value();
  return scene;
}

// In debug and release, on every CPU: a change here is a change of behaviour.
TEST(Invariants, AFixedSceneIsTheSameEachTimeAndInEveryBuild) {
  const FixedScene scene = fixed_scene();
  EXPECT_EQ(scene.hash, fixed_scene().hash);
  EXPECT_EQ(scene.trail,
            "0: 1.1989127982312624 0.47897125746727603 0.9610872017687376\n"
            "200: 1.7387297137330717 0.24970129447143943 0.061270286266928195\n"
            "400: 1.2852875783733295 0.16765259024894846 0.5147124216266705\n"
            "600: 1.20534908858246 0.061270286266928015 0.5946509114175399\n"
            "800: 0.5294429437648366 0.45013667351182773 0.6864537170576135\n");
}

}  // namespace
}  // namespace eyebridge::world
