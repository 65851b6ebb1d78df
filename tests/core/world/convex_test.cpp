#include "convex.hpp"

#include <algorithm>
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

ObjectSpec polygon(double x, double y, double theta, std::vector<Vec2> corners) {
  ObjectSpec spec;
  spec.kind = ObjectKind::Polygon;
  spec.name = "polygon";
  spec.pose = {x, y, theta};
  spec.corners = std::move(corners);
  return spec;
}

const std::vector<Vec2> kTriangle = {{0.2, 0.0}, {-0.1, 0.15}, {-0.1, -0.15}};

Convex placed(const ObjectSpec& object) {
  return {Outline(corners_of(object)), object.pose.position(),
          Heading::from_angle(object.pose.theta).forward()};
}

/// A box or a polygon somewhere; its corners lie on an ellipse.
ObjectSpec random_block(Random& random, double size) {
  const Pose pose{size * random.uniform(), size * random.uniform(), 2 * kPi * random.uniform()};
  const double a = 0.02 + 0.2 * random.uniform();
  const double b = 0.02 + 0.2 * random.uniform();
  if (random.uniform() < 0.3) return box(pose.x, pose.y, pose.theta, 2 * a, 2 * b);
  while (true) {
    std::vector<double> angles(3 + static_cast<std::size_t>(7 * random.uniform()));
    for (double& angle : angles) angle = 2 * kPi * random.uniform();
    std::ranges::sort(angles);
    std::vector<Vec2> corners;
    for (const double angle : angles) corners.push_back({a * std::cos(angle), b * std::sin(angle)});
    if (!fault_of_corners(corners)) return polygon(pose.x, pose.y, pose.theta, corners);
  }
}

/// A closed room in its place, for what is known of walls.
WorldModel walls_around(const Convex& shape) {
  WorldModel model;
  for (std::size_t i = 0; i < shape.count; ++i) {
    Wall wall;
    wall.a = shape.corner[i];
    wall.b = shape.corner[(i + 1) % shape.count];
    model.walls.push_back(wall);
  }
  return model;
}

TEST(Convex, RaysFromOutsideMeetThemWhereTheyMeetFourWalls) {
  Random random(5);
  int met = 0;
  for (int i = 0; i < 300; ++i) {
    const Convex r = placed(random_block(random, 1.0));
    const RayCaster walls(walls_around(r), RayMethod::BruteForce);
    const Vec2 origin{2 * random.uniform() - 0.5, 2 * random.uniform() - 0.5};
    for (const Vec2 direction : directions_around(24)) {
      const double range = nearer_convex_hit(r, origin, direction, 3.0);
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

TEST(Convex, TwoMeetAtTheFractionThatHalvingTheWayFinds) {
  Random random(6);
  int met = 0;
  for (int i = 0; i < 4000; ++i) {
    const ObjectSpec first = random_block(random, 1.0);
    const Convex a = placed(first);
    const Convex b = placed(random_block(random, 1.0));
    const Vec2 motion{2 * random.uniform() - 1, 2 * random.uniform() - 1};
    if (separation(a, b).distance < 1e-6) continue;
    const auto apart = [&](double t) {
      ObjectSpec moved = first;
      moved.pose.x += t * motion.x;
      moved.pose.y += t * motion.y;
      return separation(placed(moved), b).distance;
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
    const double fraction = convex_contact(a, b, motion, 0.0);
    if (expected <= 1.0) {
      ASSERT_NEAR(fraction, expected, 1e-9) << i;
      ++met;
    } else if (fraction <= 1.0) {  // grazed between two of the steps
      ASSERT_LT(apart(fraction), 1e-9) << i;
    }
  }
  EXPECT_GT(met, 500);
}

TEST(Convex, ThatTouchSlideAlongEachOtherAndGoApart) {
  const Convex a = placed(box(0, 0, 0, 0.2, 0.2));
  const Convex b = placed(box(0.2 + 1e-7, 0.05, 0, 0.2, 0.6));
  EXPECT_NEAR(convex_contact(a, b, {0.01, 0}, 1e-7), 0.0, 1e-12);
  EXPECT_EQ(convex_contact(a, b, {0, 0.01}, 1e-7), kNoContact) << "parallel";
  EXPECT_EQ(convex_contact(a, b, {-0.01, 0.01}, 1e-7), kNoContact) << "away";
}

TEST(Convex, ThatOverlapMayOnlyGoApart) {
  const Convex a = placed(box(0, 0, 0, 0.2, 0.2));
  const Convex b = placed(box(0.15, 0, 0, 0.2, 0.6));
  EXPECT_EQ(convex_contact(a, b, {0.01, 0}, 1e-7), 0.0);
  EXPECT_EQ(convex_contact(a, b, {-0.01, 0}, 1e-7), kNoContact);
}

TEST(Convex, ADiscMeetsSidesAndCorners) {
  const Convex r = placed(box(0, 0, 0, 0.4, 0.2));
  EXPECT_NEAR(disc_convex_contact(r, {-1, 0}, {1, 0}, 0.1), 0.7, 1e-12);
  EXPECT_NEAR(disc_convex_contact(r, {0.1, 1}, {0, -1}, 0.1), 0.8, 1e-12);
  // At the corner (0.2, 0.1) from the upper right, along the diagonal.
  const Vec2 from{1.2, 1.1};
  EXPECT_NEAR(disc_convex_contact(r, from, {-1, -1}, 0.1), 1 - 0.1 / std::sqrt(2.0), 1e-12);
  EXPECT_EQ(disc_convex_contact(r, {-1, 0.21}, {2, 0}, 0.1), kNoContact) << "past it";
  EXPECT_EQ(disc_convex_contact(r, {0.1, 0}, {1, 0}, 0.1), kNoContact) << "out of it";
}

TEST(Convex, AreSeenAsTheyStand) {
  World world = world_of(room(4, 2), {box(2, 1, 0, 0.4, 0.2), box(3, 1, kPi / 4, 0.2, 0.2)});
  const BodyId robot = world.add_robot({1, 1, 0}, 0.1, 0.1, {});
  EXPECT_NEAR(world.cast_ray({1, 1}, {1, 0}, 5, robot), 0.8, 1e-12);
  EXPECT_NEAR(world.cast_ray({2, 0.5}, {0, 1}, 5, robot), 0.4, 1e-12);
  EXPECT_NEAR(world.cast_ray({3, 0.1}, {0, 1}, 5, robot), 0.9 - 0.1 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(world.cast_ray({2.21, 0.5}, {0, 1}, 5, robot), 1.5, 1e-12) << "past it";
  const Scene scene = world.scene(0);
  EXPECT_EQ(scene.bodies[0].shape, BodyShape::Polygon);
  ASSERT_NE(scene.bodies[0].corners, nullptr);
  EXPECT_EQ(*scene.bodies[0].corners,
            (std::vector<Vec2>{{0.2, 0.1}, {-0.2, 0.1}, {-0.2, -0.1}, {0.2, -0.1}}));
  EXPECT_EQ(scene.bodies[2].corners, nullptr) << "a robot";
  EXPECT_FALSE(world.is_free({2.25, 1}, 0.06));
  EXPECT_TRUE(world.is_free({2.25, 1}, 0.04)) << "free beside it, within the disc that covers it";
  EXPECT_THROW(world.add_robot({2.0, 1.15, 0}, 0.06, 0.1, {}), std::invalid_argument);
}

TEST(Convex, AreTouchedAtTheirSides) {
  World world = world_of(room(4, 2), {box(2, 1, 0, 0.4, 0.2)});
  const BodyId robot = world.add_robot({1.699, 1.05, 0}, 0.1, 0.1, {});
  std::vector<Vec2> contacts;
  world.contacts(robot, 2e-3, contacts);
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_NEAR(contacts[0].x, 1.0, 1e-12);
}

TEST(Convex, ARobotPushesOneAndLeavesItStanding) {
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

TEST(Convex, AreHeldByWallsAndByWhatIsFixed) {
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

TEST(Convex, PushedObliquelyAgainstAWallSlideAlongIt) {
  World world = world_of(room(4, 2), {box(1, 0.1001, 0, 0.2, 0.2)});
  const BodyId robot = world.add_robot({0.75, 0.2, 0}, 0.1, 0.1, {});
  world.set_pose(robot, {0.75, 0.28, -0.3});
  for (int i = 0; i < 100; ++i) world.move(robot, {{0.01, 0}, {}}, kBoxStep);
  EXPECT_GT(world.position(0).x, 1.5);
  EXPECT_NEAR(world.position(0).y, 0.1, 2e-4);
  EXPECT_GE(world.position(0).y, 0.1);
}

TEST(Convex, ABallBouncesOffOneAtAnyAngle) {
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

TEST(Convex, DistanceIsThatToTheNearestPointOfTheRim) {
  Random random(8);
  for (int i = 0; i < 2000; ++i) {
    const Convex shape = placed(random_block(random, 1.0));
    const Vec2 p{2 * random.uniform() - 0.5, 2 * random.uniform() - 0.5};
    double rim = 1e9;
    bool within = true;
    for (std::size_t k = 0; k < shape.count; ++k) {
      const Vec2 a = shape.corner[k];
      const Vec2 b = shape.corner[(k + 1) % shape.count];
      rim = std::min(rim, norm(p - closest_point(segment_between(a, b), p)));
      within = within && cross(b - a, p - a) > 0.0;
    }
    ASSERT_NEAR(distance_to(shape, p), within ? -rim : rim, 1e-12) << i;
    ASSERT_NEAR(norm(p - closest_point(shape, p)), within ? 0.0 : rim, 1e-12) << i;
  }
}

TEST(Convex, ATriangleIsSeenAndPushedWhereItsSidesAre) {
  World world = world_of(room(4, 2), {polygon(2, 1, 0, kTriangle)});
  EXPECT_NEAR(world.cast_ray({1, 1}, {1, 0}, 5, kNoBody), 0.9, 1e-12);
  EXPECT_NEAR(world.cast_ray({3, 1}, {-1, 0}, 5, kNoBody), 0.8, 1e-12);
  EXPECT_NEAR(world.cast_ray({2.05, 0.2}, {0, 1}, 5, kNoBody), 0.725, 1e-12) << "half-way down";
  EXPECT_DOUBLE_EQ(world.radius(0), 0.2);
  const BodyId robot = world.add_robot({1.5, 1.02, 0}, 0.1, 0.1, {});
  for (int i = 0; i < 100; ++i) world.move(robot, {{0.01, 0}, {}}, kBoxStep);
  EXPECT_NEAR(world.position(0).x, 2.5 + 0.1 + 0.1, 1e-6) << "by its flat back";
  EXPECT_EQ(world.position(0).y, 1.0);
}

TEST(Convex, ATriangleIsPushedAsideByItsSlantedFlank) {
  World world = world_of(room(4, 2), {polygon(2, 1, 0, kTriangle)});
  const BodyId robot = world.add_robot({2.1, 0.5, kPi / 2}, 0.1, 0.1, {});
  for (int i = 0; i < 50; ++i) world.move(robot, {{0.01, 0}, {}}, kBoxStep);
  const Vec2 way = world.position(0) - Vec2{2, 1};
  EXPECT_GT(way.y, 0.1);
  EXPECT_NEAR(way.x / way.y, -0.5, 1e-9) << "along the normal of the flank, (0.15, -0.3)";
  std::vector<Vec2> contacts;
  world.contacts(robot, 1e-3, contacts);
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_NEAR(contacts[0].x / contacts[0].y, -0.5, 1e-3);
}

/// A floor whose lower side other walls meet, at right angles and not.
WorldModel floor_with_walls_below() {
  WorldModel model = room(4, 2);
  for (const Vec2 foot : {Vec2{1.5, 0.2}, Vec2{2.0, 0.1}, Vec2{3.2, 0.3}}) {
    Wall wall;
    wall.a = foot;
    wall.b = {foot.x < 3 ? foot.x : 2.5, 1.0};
    model.walls.push_back(wall);
  }
  Wall floor;
  floor.a = {0.5, 1.0};
  floor.b = {3.5, 1.0};
  model.walls.push_back(floor);
  Wall thick;  // whose outline has corners in the middle of the floor
  thick.a = {2.2, 0.9};
  thick.b = {2.3, 0.9};
  thick.thickness = 0.2;
  model.walls.push_back(thick);
  return model;
}

TEST(Convex, WhatSlidesAlongAWallIsNotCaughtByWallsThatMeetItFromBehind) {
  const std::vector<Vec2> tip_down = {{0.0, -0.1}, {0.08, 0.06}, {-0.08, 0.06}};
  const std::vector<Vec2> needle = {{0.0, -0.1}, {0.015, 0.06}, {-0.015, 0.06}};
  std::vector<ObjectSpec> sliders = {polygon(0.7, 0, 0, tip_down), polygon(0.7, 0, 0, needle)};
  for (const double degrees : {0.0, 5.0, 20.0, 30.0, 45.0, 60.0, 85.0}) {
    sliders.push_back(box(0.7, 0, deg_to_rad(degrees), 0.2, 0.15));
  }
  for (ObjectSpec& slider : sliders) {
    slider.matter.friction = 0.0;
    slider.matter.restitution = 0.0;
    double lowest = 0.0;
    const Heading heading = Heading::from_angle(slider.pose.theta);
    for (const Vec2 corner : corners_of(slider)) {
      lowest = std::min(lowest, heading.rotate(corner).y);
    }
    slider.pose.y = 1.0 - lowest + 2e-7;
    World world = world_of(floor_with_walls_below(), {slider});
    // A little downward, so that the floor is met, and then along it.
    world.set_velocity(0, {1.0, -0.001});
    for (int i = 0; i < 220; ++i) world.step_objects(kBoxStep);
    EXPECT_GT(world.position(0).x, 2.8) << slider.name << ' ' << slider.pose.theta;
    EXPECT_NEAR(world.position(0).y, slider.pose.y, 1e-6);
  }
}

TEST(Convex, TheToldPlaceOfAContactIsWhereTheyTouch) {
  // A bar that comes down on the floor by its lower corner; a box by its side on half a box.
  const Convex floor(segment_between({0, 0}, {2, 0}));
  const Convex bar = placed(box(1, 0.19330127, deg_to_rad(30), 0.6, 0.1));
  const Vec2 by_corner = contact_place(bar, floor, {0, -1});
  EXPECT_NEAR(by_corner.x, 1 - 0.3 * std::cos(kPi / 6) + 0.05 * 0.5, 1e-6);
  EXPECT_NEAR(by_corner.y, 0.0, 1e-6);
  const Convex above = placed(box(1, 0.1, 0, 0.4, 0.2));
  const Convex below = placed(box(1.3, -0.1, 0, 0.4, 0.2));
  EXPECT_NEAR(contact_place(above, below, {0, -1}).x, 1.15, 1e-9) << "the middle of 1.1 to 1.2";
  const Convex over_all = placed(box(1, 0.1, 0, 0.4, 0.2));
  EXPECT_NEAR(contact_place(over_all, floor, {0, -1}).x, 1.0, 1e-9);
}

TEST(Convex, CornersThatCannotBeAreToldByTheirNumber) {
  const auto corner = [](const std::vector<Vec2>& corners) {
    return fault_of_corners(corners)->corner;
  };
  EXPECT_EQ(fault_of_corners(kTriangle), std::nullopt);
  EXPECT_EQ(corner({{0.1, 0}, {-0.1, 0.1}}), 2U) << "too few";
  EXPECT_EQ(corner(std::vector<Vec2>(kMostCorners + 1)), kMostCorners) << "too many";
  EXPECT_EQ(corner({{0.1, -0.1}, {0.1, 0.1}, {0.1, 0.1}, {-0.1, 0.0}}), 2U) << "twice the same";
  EXPECT_EQ(corner({{0.2, -0.1}, {0.2, 0.1}, {0.1, 0.0}}), 1U) << "the origin is outside";
  EXPECT_EQ(corner({{-0.1, -0.15}, {-0.1, 0.15}, {0.2, 0.0}}), 0U) << "clockwise";
  EXPECT_EQ(corner({{0.2, -0.2}, {0.05, 0.0}, {0.2, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}}), 2U)
      << "a dent at the second one, told of at the next";
  std::vector<Vec2> star;
  for (int i = 0; i < 5; ++i) {
    const double angle = 4 * kPi * i / 5;
    star.push_back({std::cos(angle), std::sin(angle)});
  }
  EXPECT_TRUE(fault_of_corners(star).has_value()) << "left turns alone do not make it convex";
  EXPECT_TRUE(fault_of_corners({{NAN, 0}, {0, 1}, {-1, -1}}).has_value());
  ObjectSpec dented = polygon(1, 1, 0, {{0.2, -0.1}, {0.2, 0.1}, {0.1, 0.0}});
  EXPECT_THROW(world_of(room(2, 2), {dented}), std::invalid_argument);
}

}  // namespace
}  // namespace eyebridge::world
