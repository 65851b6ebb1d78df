#include "boxes.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"
#include "eyebridge/world/world.hpp"
#include "scenes.hpp"

namespace eyebridge::world {
namespace {

constexpr double kBoxStep = 0.01;

ObjectSpec box(double x, double y, double theta, double length, double width) {
  ObjectSpec spec;
  spec.kind = ObjectKind::Box;
  spec.name = "box";
  spec.pose = {x, y, theta};
  spec.size = {length, width};
  return spec;
}

World world_of(WorldModel model, std::initializer_list<ObjectSpec> objects) {
  model.objects = objects;
  return World(shared(std::move(model)));
}

Rectangle random_rectangle(Random& random, double size) {
  return {{size * random.uniform(), size * random.uniform()},
          Heading::from_angle(2 * kPi * random.uniform()).forward(),
          {0.02 + 0.2 * random.uniform(), 0.02 + 0.2 * random.uniform()}};
}

/// The rectangle as a closed room of four walls, for what is known of walls.
WorldModel walls_around(const Rectangle& r) {
  WorldModel model;
  const Vec2 v{-r.u.y, r.u.x};
  const Vec2 corners[] = {
      r.centre + r.half.x * r.u + r.half.y * v, r.centre - r.half.x * r.u + r.half.y * v,
      r.centre - r.half.x * r.u - r.half.y * v, r.centre + r.half.x * r.u - r.half.y * v};
  for (std::size_t i = 0; i < 4; ++i) {
    Wall wall;
    wall.a = corners[i];
    wall.b = corners[(i + 1) % 4];
    model.walls.push_back(wall);
  }
  return model;
}

TEST(Boxes, RaysFromOutsideMeetThemWhereTheyMeetFourWalls) {
  Random random(5);
  int met = 0;
  for (int i = 0; i < 300; ++i) {
    const Rectangle r = random_rectangle(random, 1.0);
    const RayCaster walls(walls_around(r), RayMethod::BruteForce);
    const Vec2 origin{2 * random.uniform() - 0.5, 2 * random.uniform() - 0.5};
    for (const Vec2 direction : directions_around(24)) {
      const double range = nearer_box_hit(r, origin, direction, 3.0);
      if (distance_to(r, origin) <= 0.0) {
        ASSERT_EQ(range, 0.0) << "within it";
        continue;
      }
      ASSERT_NEAR(range, walls.cast(origin, direction, 3.0), 1e-9);
      met += range < 3.0 ? 1 : 0;
    }
  }
  EXPECT_GT(met, 300);
}

TEST(Boxes, TwoMeetAtTheFractionThatHalvingTheWayFinds) {
  Random random(6);
  int met = 0;
  for (int i = 0; i < 4000; ++i) {
    const Rectangle a = random_rectangle(random, 1.0);
    const Rectangle b = random_rectangle(random, 1.0);
    const Vec2 motion{2 * random.uniform() - 1, 2 * random.uniform() - 1};
    if (separation(a, b).distance < 1e-6) continue;
    const auto apart = [&](double t) {
      Rectangle moved = a;
      moved.centre = a.centre + t * motion;
      return separation(moved, b).distance;
    };
    // The first overlap among fine steps, then the place of contact between two of them.
    double expected = kNoContact;
    for (int k = 1; k <= 400 && expected > 1.0; ++k) {
      if (apart(k / 400.0) > 0.0) continue;
      double free = (k - 1) / 400.0;
      double hit = k / 400.0;
      for (int n = 0; n < 50; ++n) (apart((free + hit) / 2) > 0.0 ? free : hit) = (free + hit) / 2;
      expected = hit;
    }
    const double fraction = box_contact(a, b, motion, 0.0);
    if (expected <= 1.0) {
      ASSERT_NEAR(fraction, expected, 1e-9) << i;
      ++met;
    } else if (fraction <= 1.0) {  // grazed between two of the steps
      ASSERT_LT(apart(fraction), 1e-9) << i;
    }
  }
  EXPECT_GT(met, 500);
}

TEST(Boxes, ThatTouchSlideAlongEachOtherAndGoApart) {
  const Rectangle a{{0, 0}, {1, 0}, {0.1, 0.1}};
  const Rectangle b{{0.2 + 1e-7, 0.05}, {1, 0}, {0.1, 0.3}};
  EXPECT_EQ(box_contact(a, b, {0.01, 0}, 1e-7), 0.0);
  EXPECT_EQ(box_contact(a, b, {0, 0.01}, 1e-7), kNoContact) << "parallel";
  EXPECT_EQ(box_contact(a, b, {-0.01, 0.01}, 1e-7), kNoContact) << "away";
}

TEST(Boxes, ThatOverlapMayOnlyGoApart) {
  const Rectangle a{{0, 0}, {1, 0}, {0.1, 0.1}};
  const Rectangle b{{0.15, 0}, {1, 0}, {0.1, 0.3}};
  EXPECT_EQ(box_contact(a, b, {0.01, 0}, 1e-7), 0.0);
  EXPECT_EQ(box_contact(a, b, {-0.01, 0}, 1e-7), kNoContact);
}

TEST(Boxes, ADiscMeetsSidesAndCorners) {
  const Rectangle r{{0, 0}, {1, 0}, {0.2, 0.1}};
  EXPECT_NEAR(disc_box_contact(r, {-1, 0}, {1, 0}, 0.1), 0.7, 1e-12);
  EXPECT_NEAR(disc_box_contact(r, {0.1, 1}, {0, -1}, 0.1), 0.8, 1e-12);
  // At the corner (0.2, 0.1) from the upper right, along the diagonal.
  const Vec2 from{1.2, 1.1};
  EXPECT_NEAR(disc_box_contact(r, from, {-1, -1}, 0.1), 1 - 0.1 / std::sqrt(2.0), 1e-12);
  EXPECT_EQ(disc_box_contact(r, {-1, 0.21}, {2, 0}, 0.1), kNoContact) << "past it";
  EXPECT_EQ(disc_box_contact(r, {0.1, 0}, {1, 0}, 0.1), kNoContact) << "out of it";
}

TEST(Boxes, AreSeenAsTheyStand) {
  World world = world_of(room(4, 2), {box(2, 1, 0, 0.4, 0.2), box(3, 1, kPi / 4, 0.2, 0.2)});
  const BodyId robot = world.add_robot({1, 1, 0}, 0.1, 0.1, {});
  EXPECT_NEAR(world.cast_ray({1, 1}, {1, 0}, 5, robot), 0.8, 1e-12);
  EXPECT_NEAR(world.cast_ray({2, 0.5}, {0, 1}, 5, robot), 0.4, 1e-12);
  EXPECT_NEAR(world.cast_ray({3, 0.1}, {0, 1}, 5, robot), 0.9 - 0.1 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(world.cast_ray({2.21, 0.5}, {0, 1}, 5, robot), 1.5, 1e-12) << "past it";
  const Scene scene = world.scene(0);
  EXPECT_EQ(scene.bodies[0].shape, BodyShape::Box);
  EXPECT_EQ(scene.bodies[0].size, (Vec2{0.4, 0.2}));
  EXPECT_FALSE(world.is_free({2.25, 1}, 0.06));
  EXPECT_TRUE(world.is_free({2.25, 1}, 0.04)) << "free beside it, within the disc that covers it";
  EXPECT_THROW(world.add_robot({2.0, 1.15, 0}, 0.06, 0.1, {}), std::invalid_argument);
}

TEST(Boxes, AreTouchedAtTheirSides) {
  World world = world_of(room(4, 2), {box(2, 1, 0, 0.4, 0.2)});
  const BodyId robot = world.add_robot({1.699, 1.05, 0}, 0.1, 0.1, {});
  std::vector<Vec2> contacts;
  world.contacts(robot, 2e-3, contacts);
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_NEAR(contacts[0].x, 1.0, 1e-12);
}

TEST(Boxes, ARobotPushesOneAndLeavesItStanding) {
  World world = world_of(room(4, 2), {box(2, 1, 0, 0.4, 0.2)});
  const BodyId robot = world.add_robot({1.5, 1.04, 0}, 0.1, 0.1, {});
  for (int i = 0; i < 100; ++i) {
    world.move(robot, {{0.01, 0}, {}}, kBoxStep);
    world.step_objects(kBoxStep);
  }
  EXPECT_NEAR(world.position(robot).x, 2.5, 1e-12) << "the box did not slow it";
  EXPECT_NEAR(world.position(0).x, 2.5 + 0.1 + 0.2, 1e-6);
  EXPECT_EQ(world.position(0).y, 1.0) << "pushed along the normal of its side";
  const Vec2 before = world.position(0);
  for (int i = 0; i < 10; ++i) world.step_objects(kBoxStep);
  EXPECT_EQ(world.position(0), before);
}

TEST(Boxes, AreHeldByWallsAndByWhatIsFixed) {
  ObjectSpec post = box(3, 1, kPi / 4, 0.1, 0.1);
  post.matter.fixed = true;
  for (const bool fixed : {false, true}) {
    World world = fixed ? world_of(room(4, 2), {box(2, 1, 0, 0.4, 0.2), post})
                        : world_of(room(3, 2), {box(2, 1, 0, 0.4, 0.2)});
    const BodyId robot = world.add_robot({1.5, 1, 0}, 0.1, 0.1, {});
    MoveResult last;
    for (int i = 0; i < 150; ++i) last = world.move(robot, {{0.01, 0}, {}}, kBoxStep);
    const double end = fixed ? 3 - 0.05 * std::sqrt(2.0) : 3.0;
    EXPECT_NEAR(world.position(0).x, end - 0.2, 1e-6);
    EXPECT_NEAR(world.position(robot).x, end - 0.4 - 0.1, 1e-6);
    EXPECT_EQ(last.hit_body, 0u);
    EXPECT_LT(last.fraction, 1e-5);
  }
}

TEST(Boxes, PushedObliquelyAgainstAWallSlideAlongIt) {
  World world = world_of(room(4, 2), {box(1, 0.1001, 0, 0.2, 0.2)});
  const BodyId robot = world.add_robot({0.75, 0.2, 0}, 0.1, 0.1, {});
  world.set_pose(robot, {0.75, 0.28, -0.3});
  for (int i = 0; i < 100; ++i) world.move(robot, {{0.01, 0}, {}}, kBoxStep);
  EXPECT_GT(world.position(0).x, 1.5);
  EXPECT_NEAR(world.position(0).y, 0.1, 2e-4);
  EXPECT_GE(world.position(0).y, 0.1);
}

TEST(Boxes, ABallBouncesOffOneAtAnyAngle) {
  ObjectSpec ball;
  ball.pose = {1, 1, 0};
  ball.matter.friction = 0.0;
  ball.matter.restitution = 1.0;
  ObjectSpec mirror = box(2, 1, kPi / 4, 0.5, 0.5);
  World world = world_of(room(4, 4), {ball, mirror});
  world.set_velocity(0, {1, 0});
  // The corner points left; hit it a little above, on its upper left side.
  world.set_pose(0, {1, 1.1, 0});
  world.set_velocity(0, {1, 0});
  for (int i = 0; i < 120; ++i) world.step_objects(kBoxStep);
  EXPECT_NEAR(world.velocity(0).x, 0.0, 1e-9);
  EXPECT_NEAR(world.velocity(0).y, 1.0, 1e-9);
}

}  // namespace
}  // namespace eyebridge::world
