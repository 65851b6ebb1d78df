#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "eyebridge/base/random.hpp"
#include "rig.hpp"

namespace eyebridge::robot {
namespace {

TEST(Simulation, RefusesARobotInAWall) {
  Simulation sim(room(1.0, 1.0), {});
  EXPECT_THROW(sim.add_robot({}, {0.05, 0.5, 0.0}), std::invalid_argument);
  EXPECT_EQ(sim.robot_count(), 0u);
}

TEST(Simulation, RefusesModelsThatCannotBe) {
  Simulation sim(room(4.0, 4.0), {});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refuses = [&](auto change) {
    RobotModel model;
    change(model);
    try {
      sim.add_robot(model, {2.0, 2.0, 0.0});
    } catch (const std::invalid_argument&) {
      return true;
    }
    return false;
  };
  EXPECT_TRUE(refuses([](RobotModel& m) { m.drive.wheel_base = 0.0; }));
  EXPECT_TRUE(refuses([](RobotModel& m) { m.drive.wheel_diameter = -0.05; }));
  EXPECT_TRUE(refuses([&](RobotModel& m) { m.drive.max_wheel_speed = nan; }));
  EXPECT_TRUE(refuses([](RobotModel& m) { m.drive.ticks_per_revolution = 0.0; }));
  EXPECT_TRUE(refuses([](RobotModel& m) { m.drive.max_linear = -1.0; }));
  EXPECT_TRUE(refuses([](RobotModel& m) { m.drive.angular_acceleration = -1.0; }));
  EXPECT_TRUE(refuses([](RobotModel& m) { m.drive.motor_time_constant = -0.1; }));
  EXPECT_TRUE(refuses([](RobotModel& m) { m.diameter = 0.0; }));
  EXPECT_FALSE(refuses([](RobotModel&) {}));
}

TEST(Simulation, RefusesSettingsThatCannotBe) {
  SimulationSettings settings;
  settings.step = 0.0;
  EXPECT_THROW(Simulation(room(1.0, 1.0), settings), std::invalid_argument);
  settings.step = 0.01;
  settings.stall_timeout = -1.0;
  EXPECT_THROW(Simulation(room(1.0, 1.0), settings), std::invalid_argument);
}

TEST(Simulation, AnEndlessStallTimeOutNeverComes) {
  SimulationSettings settings;
  settings.stall_timeout = std::numeric_limits<double>::infinity();
  Rig rig({}, {3.9, 2.0, 0.0}, settings);
  rig.sim.drive(rig.robot, {1.0, 0.0, 0.3});
  rig.steps(2000);
  EXPECT_EQ(rig.sim.drive_state(rig.robot), DriveState::Driving);
  EXPECT_EQ(rig.sim.stalled(rig.robot), kStallBoth);
}

TEST(Simulation, TimeIsStepsTimesStep) {
  SimulationSettings settings;
  settings.step = 0.02;
  Rig rig({}, {2.0, 2.0, 0.0}, settings);
  EXPECT_EQ(rig.sim.time(), 0.0);
  rig.steps(12345);
  EXPECT_EQ(rig.sim.time(), 12345 * 0.02);
}

TEST(Simulation, AnotherStepEndsAtTheSamePlace) {
  for (const double step : {0.001, 0.02, 0.05}) {
    SimulationSettings settings;
    settings.step = step;
    Rig rig({}, {1.0, 2.0, 0.0}, settings);
    rig.sim.drive(rig.robot, {1.0, 0.0, 0.4});
    const int steps = rig.finish();
    EXPECT_NEAR(rig.sim.pose(rig.robot).x, 2.0, 1e-9);
    EXPECT_NEAR(steps * step, 1.0 / 0.4 + 0.4, 2.1 * step);
  }
}

TEST(Simulation, CanBeMoved) {
  Rig rig;
  rig.sim.set_speed(rig.robot, {0.2, 0.0});
  Simulation moved = std::move(rig.sim);
  for (int i = 0; i < 100; ++i) moved.step();
  EXPECT_GT(moved.pose(0).x, 2.1);
}

TEST(Simulation, PushesABallOutOfTheWay) {
  auto model = std::make_shared<world::WorldModel>(*room(4.0, 4.0));
  world::ObjectSpec ball;
  ball.pose = {1.5, 2.0, 0.0};
  model->objects.push_back(ball);
  Simulation sim(model, {});
  const RobotIndex robot = sim.add_robot({}, {1.0, 2.0, 0.0});
  EXPECT_EQ(sim.body(robot), 1u) << "objects come first";
  sim.drive(robot, {1.0, 0.0, 0.3});
  for (int i = 0; i < 500; ++i) sim.step();
  EXPECT_NEAR(sim.pose(robot).x, 2.0, 1e-9) << "a ball does not hold a robot up";
  EXPECT_GT(sim.world().position(0).x, 2.0);
}

TEST(Simulation, EveryGoalOfARealisticRobotEnds) {
  RobotModel model;
  model.drive_error = {0.05, 0.05, 0.01, -0.01, true};
  Random random(5);
  for (const double time_constant : {0.0, 0.02, 0.1}) {
    model.drive.motor_time_constant = time_constant;
    Rig rig(model);
    for (int goal = 0; goal < 60; ++goal) {
      rig.sim.set_pose(rig.robot, {2.0, 2.0, 0.0});
      const double distance = goal % 3 == 0 ? 0.0 : 1.6 * random.uniform() - 0.8;
      const double angle = goal % 3 == 1 ? 0.0 : 8.0 * random.uniform() - 4.0;
      const double speed = 0.1 + random.uniform();
      rig.sim.drive(rig.robot, {distance, angle, speed});
      // As long as the trapezoid takes, and 1.5 s for ramps, lag and the last tick.
      const double way = std::abs(distance == 0.0 ? angle : distance);
      const double slowest = std::max(way / std::min(speed, distance == 0.0 ? 5.0 : 0.6),
                                      std::abs(angle) / deg_to_rad(300));
      EXPECT_LT(rig.finish() * 0.01, slowest + 1.5) << distance << " m, " << angle << " rad";
      EXPECT_EQ(rig.sim.drive_state(rig.robot), DriveState::Idle);
    }
  }
}

}  // namespace
}  // namespace eyebridge::robot
