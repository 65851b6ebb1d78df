#include <vector>

#include <gtest/gtest.h>

#include "eyebridge/base/random.hpp"
#include "eyebridge/base/units.hpp"
#include "rig.hpp"
#include "sensing.hpp"

namespace eyebridge::robot {
namespace {

constexpr RobotIndex kMany = 8;
constexpr double kBoxSize = 0.2;

world::ObjectSpec box_at(double x, double y, double theta) {
  world::ObjectSpec spec;
  spec.kind = world::ObjectKind::Box;
  spec.size = {kBoxSize, kBoxSize};
  spec.pose = {x, y, theta};
  return spec;
}

std::shared_ptr<const world::WorldModel> room_with(double size,
                                                   std::vector<world::ObjectSpec> objects) {
  auto model = std::make_shared<world::WorldModel>(*room(size, size));
  model->objects = std::move(objects);
  return model;
}

RobotModel seeing_robot() {
  RobotModel model;
  for (int i = 0; i < 6; ++i) {
    RangeSensorModel sensor;
    sensor.pose_in_robot = {0.0, 0.0, deg_to_rad(60.0 * i)};
    model.range_sensors.push_back(sensor);
  }
  model.lidar = LidarModel{};
  model.kicker = KickerModel{0, 1.5, 0.05, deg_to_rad(40)};
  return model;
}

/// Drives and sensors that err: not at all, by scale only, by chance, or by lost ticks.
RobotModel erring(RobotModel model, std::uint64_t kind) {
  DriveError& drive = model.drive_error;
  drive = {};
  if (kind == 1) drive.left_scale = 0.02;
  if (kind == 2) drive.slip = 0.1;
  if (kind == 3) drive.encoder_miss = 0.05;
  if (kind == 4) drive.linear_sigma = drive.angular_sigma = 0.05;
  for (RangeSensorModel& sensor : model.range_sensors) {
    sensor.error = {};
    if (kind >= 3) sensor.error.dropout = 0.2;
  }
  return model;
}

/// Robots among boxes, balls and obstacles on paths; `thinks_anew` keeps robots from what they may
/// skip.
struct Fair {
  explicit Fair(bool thinks_anew_each_step) : thinks_anew(thinks_anew_each_step) {
    for (RobotIndex i = 0; i < kMany; ++i) {
      RobotModel model = seeing_robot();
      if (i % 2 == 0) model.drive.linear_acceleration = model.drive.angular_acceleration = 0.0;
      const RobotIndex row = i / 4;
      sim.add_robot(erring(model, i % 5), {0.4 + 0.5 * (i % 4), 0.4 + 1.6 * row, 0.7 * i});
    }
  }

  static std::vector<world::ObjectSpec> things() {
    std::vector<world::ObjectSpec> things;
    things.push_back(box_at(0.5, 1.2, 0.0));
    things.back().path = world::Path{0.2, false, {{1.9, 1.2}, {1.9, 0.9}}};
    things.push_back(box_at(1.0, 0.9, 0.4));
    things.push_back(box_at(1.5, 1.6, 0.9));
    things.back().matter.fixed = true;
    for (int i = 0; i < 3; ++i) {
      world::ObjectSpec ball;
      ball.kind = world::ObjectKind::Ball;
      ball.pose = {0.5 + 0.6 * i, 1.45, 0.0};
      things.push_back(ball);
    }
    return things;
  }

  void command(RobotIndex robot, double kind, double a, double b) {
    if (kind < 0.5) sim.set_speed(robot, {0.4 * a, b});
    if (kind >= 0.5 && kind < 0.6) sim.set_speed(robot, {0.3, 0.0});
    if (kind >= 0.6 && kind < 0.7) sim.drive(robot, {a, b, 0.4});
    if (kind >= 0.7 && kind < 0.8) sim.set_servo(robot, 0, a);
    if (kind >= 0.8)
      sim.set_errors(robot, erring(sim.model(robot), static_cast<unsigned>(20 * kind) % 5));
  }

  void step() {
    for (RobotIndex robot = 0; thinks_anew && robot < kMany; ++robot) sim.reset_encoder(robot, 0);
    sim.step();
  }

  bool thinks_anew;
  Simulation sim{room_with(2.4, things()), {}};
};

TEST(CruiseAmongThings, WhatIsNotComputedAgainIsTheSame) {
  Fair fast(false);
  Fair slow(true);
  Random random(6);
  for (int step = 0; step < 10000; ++step) {
    for (RobotIndex robot = 0; robot < kMany; ++robot) {
      if (!random.chance(0.01)) continue;
      const double kind = random.uniform();
      const double a = 2 * random.uniform() - 1;
      const double b = 2 * random.uniform() - 1;
      for (Fair* fair : {&fast, &slow}) fair->command(robot, kind, a, b);
    }
    fast.step();
    slow.step();
    if (step % 7 != 0) continue;  // who looks must not be what keeps them alike
    ASSERT_EQ(fast.sim.state_hash(), slow.sim.state_hash()) << step;
    const auto robot = static_cast<RobotIndex>(step) % kMany;
    ASSERT_EQ(fast.sim.encoder_ticks(robot, 1), slow.sim.encoder_ticks(robot, 1)) << step;
    std::vector<double> at_once(6);
    fast.sim.read_ranges(robot, at_once);
    for (std::size_t i = 0; i < 6; ++i) {
      ASSERT_EQ(at_once[i], slow.sim.read_range(robot, i)) << step << ", sensor " << i;
    }
  }
  const auto told = fast.sim.collisions();
  const auto expected = slow.sim.collisions();
  ASSERT_EQ(fast.sim.collision_count(), slow.sim.collision_count());
  ASSERT_EQ(told.size(), expected.size());
  for (std::size_t i = 0; i < told.size(); ++i) {
    EXPECT_EQ(told[i].time, expected[i].time);
    EXPECT_EQ(told[i].body, expected[i].body);
    EXPECT_EQ(told[i].with_body, expected[i].with_body);
    EXPECT_EQ(told[i].place, expected[i].place);
  }
  EXPECT_GT(fast.sim.collision_count(), 100u);
}

TEST(CruiseAmongThings, RaysBesideRobotsThatCruiseMeetBoxesAsSingleRaysDo) {
  Fair fair(false);
  const world::World& world = fair.sim.world();
  for (RobotIndex robot = 0; robot < kMany; ++robot) fair.sim.set_speed(robot, {0.1, 0.2});
  int of_objects = 0;
  std::vector<double> scan(360);
  const ScanShape shape(2 * kPi, scan.size());
  for (int step = 0; step < 1000; ++step) {
    fair.step();
    if (step % 20 != 0) continue;
    const auto robot = static_cast<RobotIndex>(step / 20) % kMany;
    fair.sim.read_lidar(robot, 2 * kPi, scan);
    const LidarModel& lidar = *fair.sim.model(robot).lidar;
    const world::BodyId self = fair.sim.body(robot);
    const Sight sight =
        Sight(lidar.pose_in_robot).in_world(world.position(self), world.heading(self));
    for (std::size_t i = 0; i < scan.size(); ++i) {
      const Vec2 direction = sight.heading.rotate(shape.directions[i]);
      ASSERT_EQ(scan[i], world.cast_ray(sight.origin, direction, lidar.max_range, self))
          << "step " << step << ", ray " << i;
      const Vec2 met = sight.origin + scan[i] * direction;
      const bool inside = met.x > 0.01 && met.x < 2.39 && met.y > 0.01 && met.y < 2.39;
      of_objects += inside ? 1 : 0;
    }
  }
  EXPECT_GT(of_objects, 3000);
}

TEST(CruiseAmongThings, ARobotThatCruisesIsHeldByABoxThatComesAlongItsPath) {
  world::ObjectSpec comes = box_at(3.0, 2.0, 0.0);
  comes.path = world::Path{0.1, false, {{1.0, 2.0}}};
  Simulation sim(room_with(4.0, {comes}), {});
  RobotModel model;
  model.drive.linear_acceleration = 0.0;
  const RobotIndex robot = sim.add_robot(model, {0.5, 2.0, 0.0});
  sim.set_speed(robot, {0.3, 0.0});
  // They come nearer by 0.4 m/s.
  const double gap = 2.5 - kBoxSize / 2 - model.radius();
  const double meet = gap / 0.4;
  while (sim.time() < meet - 2 * sim.settings().step) {
    sim.step();
    ASSERT_EQ(sim.stalled(robot), kStallNone) << sim.time();
  }
  EXPECT_TRUE(sim.collisions().empty());
  for (int i = 0; i < 50; ++i) sim.step();
  EXPECT_EQ(sim.stalled(robot), kStallBoth);
  EXPECT_NEAR(sim.pose(robot).x, 0.5 + 0.3 * meet, 0.005);
  ASSERT_EQ(sim.collisions().size(), 1u) << "they press on against each other";
  EXPECT_NEAR(sim.collisions()[0].time, meet, 2.5 * sim.settings().step);
  EXPECT_NEAR(sim.odometry(robot).x, sim.pose(robot).x - 0.5, 1e-9);
  // Aside it goes on, and so does the box.
  const double box = sim.world().position(0).x;
  sim.set_pose(robot, {0.5, 1.0, 0.0});
  for (int i = 0; i < 100; ++i) sim.step();
  EXPECT_EQ(sim.stalled(robot), kStallNone);
  EXPECT_NEAR(sim.pose(robot).x, 0.5 + 0.3 * 100 * sim.settings().step, 1e-9);
  EXPECT_NEAR(sim.world().position(0).x, box - 0.1 * 100 * sim.settings().step, 1e-9);
}

TEST(CruiseAmongThings, ErrorsThatComeWhileItCruisesAreThoseThatItHasFromTheStart) {
  for (std::uint64_t kind = 1; kind < 5; ++kind) {
    const auto run = [&](std::uint64_t first, int changed_at) {
      Rig rig(erring(seeing_robot(), first));
      rig.sim.set_speed(rig.robot, {0.2, 0.3});
      for (int i = 0; i < 300; ++i) {
        if (i == changed_at) {
          rig.sim.set_errors(rig.robot, erring(seeing_robot(), kind));
          rig.sim.set_speed(rig.robot, {0.2, 0.3});
        }
        rig.sim.step();
      }
      std::vector<double> ranges(6);
      rig.sim.read_ranges(rig.robot, ranges);
      StateHash hash;
      hash.add(rig.sim.state_hash());
      for (const double range : ranges) hash.add(range);
      return hash.value();
    };
    EXPECT_EQ(run(kind, 150), run(kind, -1)) << "the same errors again change nothing";
    EXPECT_EQ(run(0, 0), run(kind, -1)) << "before the first step";
    EXPECT_NE(run(0, 150), run(0, -1)) << "they do err, and from a steady state";
  }
}

}  // namespace
}  // namespace eyebridge::robot
