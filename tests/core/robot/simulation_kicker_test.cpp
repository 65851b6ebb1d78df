#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "rig.hpp"

namespace eyebridge::robot {
namespace {

constexpr unsigned kServo = 2;

/// A robot at (1, 2) that looks along `heading`, with objects at places from its centre.
struct KickerRig {
  explicit KickerRig(std::vector<world::ObjectSpec> objects, double heading = 0.0)
      : sim(with(std::move(objects)), {}), robot(sim.add_robot(model(), {1.0, 2.0, heading})) {}

  static std::shared_ptr<const world::WorldModel> with(std::vector<world::ObjectSpec> objects) {
    auto model = std::make_shared<world::WorldModel>(*room(4.0, 4.0));
    model->objects = std::move(objects);
    return model;
  }
  static RobotModel model() {
    RobotModel model;
    model.kicker = KickerModel{kServo, 2.0, 0.03, deg_to_rad(20)};
    return model;
  }
  void kick() { sim.set_servo(robot, kServo, 1.0); }

  Simulation sim;
  RobotIndex robot;
};

/// A thing whose rim is `gap` metres from the robot's, `bearing` radians off +x.
world::ObjectSpec lying(double gap, double bearing = 0.0,
                        world::ObjectKind kind = world::ObjectKind::Ball) {
  world::ObjectSpec spec;
  spec.kind = kind;
  const double distance = RobotModel{}.radius() + spec.radius + gap;
  const Vec2 place = Vec2{1.0, 2.0} + distance * Heading::from_angle(bearing).forward();
  spec.pose = {place.x, place.y, 0.0};
  return spec;
}

TEST(Kicker, KicksABallStraightAhead) {
  for (const double heading : {0.0, 2.0}) {
    KickerRig rig({lying(0.01, heading)}, heading);
    rig.kick();
    const Vec2 expected = 2.0 * Heading::from_angle(heading).forward();
    EXPECT_NEAR(norm(rig.sim.world().velocity(0) - expected), 0.0, 1e-12);
    const Vec2 before = rig.sim.world().position(0);
    rig.sim.step();
    EXPECT_NEAR(norm(rig.sim.world().position(0) - before), 0.02, 1e-4);
  }
}

TEST(Kicker, AddsTheSpeedOfTheRobot) {
  KickerRig rig({lying(0.3)});
  rig.sim.set_speed(rig.robot, {0.2, 0.0});
  while (rig.sim.pose(rig.robot).x < 1.285) rig.sim.step();
  rig.kick();
  EXPECT_NEAR(rig.sim.world().velocity(0).x, 2.2, 1e-9);
}

TEST(Kicker, ReachesOnlyBallsThatLieInFront) {
  for (const world::ObjectSpec& object :
       {lying(0.031), lying(0.01, deg_to_rad(21)), lying(0.01, -deg_to_rad(21)), lying(0.01, kPi),
        lying(0.01, 0.0, world::ObjectKind::Can)}) {
    KickerRig rig({object});
    rig.kick();
    EXPECT_EQ(rig.sim.world().velocity(0), Vec2{});
  }
  KickerRig rig({lying(0.029, deg_to_rad(19))});
  rig.kick();
  EXPECT_NEAR(rig.sim.world().velocity(0).x, 2.0, 1e-12);
}

TEST(Kicker, TakesTheNearestBall) {
  KickerRig rig({lying(0.02, 0.3), lying(0.005, -0.3)});
  rig.kick();
  EXPECT_EQ(rig.sim.world().velocity(0), Vec2{});
  EXPECT_GT(norm(rig.sim.world().velocity(1)), 1.0);
}

TEST(Kicker, StrikesOnlyOnTheWayOut) {
  KickerRig rig({lying(0.01)});
  const auto speed = [&] { return rig.sim.world().velocity(0).x; };
  rig.sim.set_servo(rig.robot, kServo, 0.7);
  rig.sim.set_servo(rig.robot, 1, 1.0);
  EXPECT_EQ(speed(), 0.0) << "not far enough; another servo";
  rig.kick();
  EXPECT_GT(speed(), 1.0);
  rig.sim.world().set_velocity(0, {});
  rig.kick();
  EXPECT_EQ(speed(), 0.0) << "it is out already";
  rig.sim.set_servo(rig.robot, kServo, 0.0);
  EXPECT_EQ(speed(), 0.0);
  rig.kick();
  EXPECT_GT(speed(), 1.0);
}

TEST(Kicker, RobotsWithoutOneTurnTheirServosOnly) {
  KickerRig rig({lying(0.01)});
  const RobotIndex other = rig.sim.add_robot({}, {1.0, 2.3, 0.0});
  rig.sim.set_pose(other, {1.01, 2.0, 0.0});
  rig.sim.set_servo(other, kServo, 1.0);
  EXPECT_EQ(rig.sim.world().velocity(0), Vec2{});
}

TEST(Kicker, ThatCannotBeIsRefused) {
  Simulation sim(room(4, 4), {});
  RobotModel model = KickerRig::model();
  model.kicker->speed = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(sim.add_robot(model, {2, 2, 0}), std::invalid_argument);
  model = KickerRig::model();
  model.kicker->servo = kServoCount;
  EXPECT_THROW(sim.add_robot(model, {2, 2, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace eyebridge::robot
