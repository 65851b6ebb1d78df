// Submarines: what thrusters, drag, buoyancy, surface and floor do, against closed forms.

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "rig.hpp"

namespace eyebridge::robot {
namespace {

constexpr double kTop = 0.5;        // metres per second, both thrusters
constexpr double kDive = 0.25;      // metres per second, both thrusters
constexpr double kRise = 0.02;      // metres per second
constexpr double kGlide = 0.8;      // seconds
constexpr double kSurface = 1.6;    // metres: a hull of 0.4 m in 2 m of water
constexpr double kArm = 0.5;        // metres, of a thruster
constexpr unsigned kLeftMotor = 0;  // as DriveKind has them
constexpr unsigned kFrontMotor = 1;
constexpr unsigned kRightMotor = 2;
constexpr unsigned kBackMotor = 3;

RobotModel submarine() {
  RobotModel model;
  model.diameter = 0.4;
  model.height = 0.4;
  DriveModel& drive = model.drive;
  drive.kind = DriveKind::Submarine;
  drive.wheel_diameter = 0.05;
  drive.max_wheel_speed = kTop / 0.025;
  drive.wheel_base = 2 * kArm;
  drive.max_linear = kTop;
  drive.max_angular = kTop / kArm;
  drive.linear_acceleration = 0.25;
  drive.angular_acceleration = 0.5;
  drive.motor_time_constant = kGlide;
  drive.max_vertical = kDive;
  drive.rise_speed = kRise;
  return model;
}

/// How far something gets in `t` seconds whose speed goes from 0 to 1 with the time constant.
double way(double t) { return t - kGlide * (1.0 - std::exp(-t / kGlide)); }

void run_motors(Rig& rig, double left, double front, double right, double back) {
  const double duties[] = {left, front, right, back};
  for (unsigned i = 0; i < 4; ++i) rig.sim.set_motor_duty(rig.robot, i, duties[i]);
}

TEST(Submarine, GainsSpeedAgainstItsDragAndGlidesOn) {
  Rig rig(submarine(), {0.5, 2.0, 0.0});
  run_motors(rig, 1, 0, 1, 0);
  rig.steps(300);
  const double speed = kTop * (1.0 - std::exp(-3.0 / kGlide));
  EXPECT_NEAR(rig.sim.pose(rig.robot).x, 0.5 + kTop * way(3.0), 1e-9);
  EXPECT_NEAR(rig.sim.odometry(rig.robot).x, kTop * way(3.0), 1e-9);
  run_motors(rig, 0, 0, 0, 0);
  EXPECT_FALSE(rig.sim.is_told_to_move(rig.robot));
  rig.steps(3000);
  EXPECT_NEAR(rig.sim.pose(rig.robot).x, 0.5 + kTop * way(3.0) + speed * kGlide, 1e-7);
  EXPECT_EQ(rig.sim.twist(rig.robot), Twist{});
  EXPECT_EQ(rig.sim.pose(rig.robot).y, 2.0);
  EXPECT_EQ(rig.sim.altitude(rig.robot), kSurface) << "it floats all the time";
}

TEST(Submarine, OneThrusterTurnsItAndPushesByHalf) {
  Rig rig(submarine());
  run_motors(rig, 0, 0, 1, 0);
  rig.steps(200);
  EXPECT_NEAR(rig.sim.pose(rig.robot).theta, kTop / (2 * kArm) * way(2.0), 1e-9);
  EXPECT_NEAR(rig.sim.twist(rig.robot).linear, kTop / 2 * (way(2.0) - way(1.99)) / 0.01, 1e-9);
  run_motors(rig, 1, 0, -1, 0);
  rig.steps(1000);
  EXPECT_NEAR(rig.sim.twist(rig.robot).angular, -kTop / kArm, 1e-4);
  EXPECT_NEAR(rig.sim.twist(rig.robot).linear, 0.0, 1e-4);
}

TEST(Submarine, FrontAndBackThrustersDiveByTheirMean) {
  for (const double back : {-1.0, 0.0}) {
    Rig rig(submarine());
    run_motors(rig, 0, -1, 0, back);
    EXPECT_FALSE(rig.sim.is_told_to_move(rig.robot)) << "not in the plane";
    rig.steps(250);
    const double end = kDive * (back - 1.0) / 2 + kRise;
    EXPECT_NEAR(rig.sim.altitude(rig.robot), kSurface + end * way(2.5), 1e-12);
    EXPECT_NEAR(*rig.sim.depth(rig.robot), -end * way(2.5), 1e-12);
    EXPECT_EQ(rig.sim.pose(rig.robot), (Pose{2.0, 2.0, 0.0}));
  }
}

TEST(Submarine, RisesByItselfUntilItFloats) {
  Rig rig(submarine());
  EXPECT_EQ(rig.sim.set_altitude(rig.robot, 0.5), 0.5);
  rig.steps(1000);
  EXPECT_NEAR(rig.sim.altitude(rig.robot), 0.5 + kRise * way(10.0), 1e-12);
  rig.steps(6000);
  EXPECT_EQ(rig.sim.altitude(rig.robot), kSurface);
  EXPECT_EQ(rig.sim.depth(rig.robot), 0.0);
}

TEST(Submarine, OneWithoutBuoyancyStaysWhereItIs) {
  RobotModel model = submarine();
  model.drive.rise_speed = 0.0;
  Rig rig(model);
  run_motors(rig, 0, -1, 0, -1);
  rig.steps(200);
  run_motors(rig, 0, 0, 0, 0);
  rig.steps(3000);
  const double altitude = rig.sim.altitude(rig.robot);
  const double speed = kDive * (1.0 - std::exp(-2.0 / kGlide));
  EXPECT_NEAR(altitude, kSurface - kDive * way(2.0) - speed * kGlide, 1e-7);
  rig.steps(1000);
  EXPECT_EQ(rig.sim.altitude(rig.robot), altitude);
}

TEST(Submarine, FloorAndSurfaceHoldIt) {
  Rig rig(submarine());
  run_motors(rig, 0, -1, 0, -1);
  rig.steps(2000);
  EXPECT_EQ(rig.sim.altitude(rig.robot), 0.0);
  EXPECT_EQ(rig.sim.depth(rig.robot), kSurface);
  run_motors(rig, 0, 1, 0, 1);
  rig.steps(100);
  EXPECT_NEAR(rig.sim.altitude(rig.robot), (kDive + kRise) * way(1.0), 1e-12);
  rig.steps(2000);
  EXPECT_EQ(rig.sim.altitude(rig.robot), kSurface);
  run_motors(rig, 0, -1, 0, -1);
  rig.steps(100);
  EXPECT_NEAR(*rig.sim.depth(rig.robot), (kDive - kRise) * way(1.0), 1e-12)
      << "it begins without the speed that the surface took";
}

TEST(Submarine, APsdThatLooksDownReadsItsAltitude) {
  RobotModel model = submarine();
  RangeSensorModel down;
  down.kind = RangeKind::Down;
  down.height = 0.1;
  down.max_range = 1.2;
  down.pose_in_robot = {0.2, 0.0, 0.0};
  model.range_sensors = {down, RangeSensorModel{}};
  Rig rig(model, {1.5, 2.0, 0.0});
  EXPECT_EQ(rig.sim.read_range(rig.robot, 0), 9.999) << "the floor is out of its reach";
  rig.sim.set_altitude(rig.robot, 0.7);
  EXPECT_EQ(rig.sim.read_range(rig.robot, 0), 0.1 + 0.7);
  EXPECT_EQ(rig.sim.true_range(rig.robot, 0), 0.1 + 0.7);
  double ranges[2];
  rig.sim.read_ranges(rig.robot, ranges);
  EXPECT_EQ(ranges[0], 0.1 + 0.7);
  EXPECT_EQ(ranges[1], 2.5) << "the other one looks ahead";
  // On a robot with wheels it reads how high it sits.
  RobotModel wheeled;
  wheeled.range_sensors = {down};
  EXPECT_EQ(Rig(wheeled).sim.read_range(0, 0), 0.1);
}

TEST(Submarine, AWallHoldsItWhileItDivesAndTurns) {
  Rig rig(submarine(), {3.0, 2.0, 0.0});
  run_motors(rig, 1, -1, 1, -1);
  rig.steps(500);
  EXPECT_NEAR(rig.sim.pose(rig.robot).x, 3.8, 1e-6);
  EXPECT_EQ(rig.sim.stalled(rig.robot), kStallBoth);
  EXPECT_NEAR(*rig.sim.depth(rig.robot), (kDive - kRise) * way(5.0), 1e-12);
  run_motors(rig, -1, 0, -1, 0);
  rig.steps(200);
  EXPECT_EQ(rig.sim.stalled(rig.robot), kStallNone);
  EXPECT_NEAR(rig.sim.pose(rig.robot).x, 3.8 - kTop * way(2.0), 1e-2);
  EXPECT_NEAR(rig.sim.odometry(rig.robot).x, rig.sim.pose(rig.robot).x - 3.0, 1e-6);
  // At a slant it slides along.
  Rig other(submarine(), {3.0, 2.0, 1.2});
  run_motors(other, 1, 0, 1, 0);
  other.steps(500);
  EXPECT_GT(other.sim.pose(other.robot).y, 2.5);
}

TEST(Submarine, VwDrivesItWhileItDives) {
  Rig rig(submarine(), {1.0, 2.0, 0.0});
  rig.sim.drive(rig.robot, {1.5, 0.0, 0.3});
  rig.sim.set_motor_duty(rig.robot, kFrontMotor, -0.4);
  rig.sim.set_motor_duty(rig.robot, kBackMotor, -0.4);
  EXPECT_EQ(rig.sim.drive_state(rig.robot), DriveState::Driving) << "the command goes on";
  const int steps = rig.finish();
  EXPECT_EQ(rig.sim.drive_state(rig.robot), DriveState::Idle);
  EXPECT_LE(steps, 650) << "5 s at 0.3 m/s, and the ramps";
  EXPECT_NEAR(rig.sim.pose(rig.robot).x, 2.5, 1e-3);
  EXPECT_NEAR(*rig.sim.depth(rig.robot), (0.4 * kDive - kRise) * way(0.01 * steps), 1e-12);
  rig.sim.drive(rig.robot, {0.0, kPi / 2, 0.6});
  rig.finish();
  EXPECT_NEAR(rig.sim.pose(rig.robot).theta, kPi / 2, 2e-3);
  // Motors 1 and 3 end that, and leave the others alone; stop() ends all.
  const double depth = *rig.sim.depth(rig.robot);
  rig.sim.set_speed(rig.robot, {0.2, 0.0});
  rig.sim.set_motor_duty(rig.robot, kLeftMotor, 0.0);
  rig.sim.set_motor_duty(rig.robot, kRightMotor, 0.0);
  rig.steps(100);
  EXPECT_GT(*rig.sim.depth(rig.robot), depth);
  rig.sim.stop(rig.robot);
  rig.steps(10000);
  EXPECT_EQ(rig.sim.depth(rig.robot), 0.0);
}

TEST(Submarine, VwReachesItsSpeedByTheRampAndStopGlides) {
  Rig rig(submarine(), {0.5, 2.0, 0.0});
  rig.sim.set_speed(rig.robot, {0.25, 0.0});
  rig.steps(50);
  EXPECT_NEAR(rig.sim.twist(rig.robot).linear, 0.125, 0.002) << "0.25 m/s^2, at the step's middle";
  rig.steps(100);
  EXPECT_NEAR(rig.sim.twist(rig.robot).linear, 0.25, 1e-9);
  const double x = rig.sim.pose(rig.robot).x;
  rig.sim.stop(rig.robot);
  rig.steps(3000);
  EXPECT_NEAR(rig.sim.pose(rig.robot).x, x + 0.25 * kGlide, 1e-7);
  rig.sim.set_twist(rig.robot, {0.1, 0.3, 0.2});
  rig.steps(200);
  EXPECT_NEAR(rig.sim.body_twist(rig.robot).linear, 0.1, 1e-9);
  EXPECT_EQ(rig.sim.body_twist(rig.robot).lateral, 0.0);
  EXPECT_NEAR(rig.sim.body_twist(rig.robot).angular, 0.2, 1e-9);
}

TEST(Submarine, HasNoEncoders) {
  Rig rig(submarine());
  EXPECT_EQ(submarine().drive.motor_count(), 4u);
  EXPECT_EQ(submarine().drive.encoder_count(), 0u);
  EXPECT_THROW(static_cast<void>(rig.sim.encoder_ticks(rig.robot, 0)), std::out_of_range);
  EXPECT_THROW(rig.sim.reset_encoder(rig.robot, 0), std::out_of_range);
  EXPECT_THROW(rig.sim.set_motor_speed(rig.robot, 0, 100), std::out_of_range);
  EXPECT_THROW(rig.sim.set_motor_duty(rig.robot, 4, 0.1), std::out_of_range);
}

TEST(Submarine, AHandPutsItIntoTheWaterOnly) {
  Rig rig(submarine());
  EXPECT_EQ(rig.sim.set_altitude(rig.robot, 3.0), kSurface);
  EXPECT_EQ(rig.sim.set_altitude(rig.robot, -1.0), 0.0);
  EXPECT_EQ(rig.sim.altitude(rig.robot), 0.0);
  Rig wheeled{RobotModel{}};
  EXPECT_EQ(wheeled.sim.set_altitude(wheeled.robot, 1.0), 0.0);
  EXPECT_EQ(wheeled.sim.altitude(wheeled.robot), 0.0);
  EXPECT_FALSE(wheeled.sim.depth(wheeled.robot));
}

TEST(Submarine, TheWorldSaysHowDeepItsWaterIs) {
  auto pool = std::make_shared<world::WorldModel>(*room(4.0, 4.0));
  pool->water = 5.0;
  Simulation sim(pool, {});
  const RobotIndex robot = sim.add_robot(submarine(), {2, 2, 0});
  EXPECT_EQ(sim.altitude(robot), 4.6);
  pool = std::make_shared<world::WorldModel>(*pool);
  pool->water = 0.3;
  Simulation shallow(pool, {});
  EXPECT_THROW(shallow.add_robot(submarine(), {2, 2, 0}), std::invalid_argument);
  RobotModel bad = submarine();
  bad.drive.max_vertical = -1.0;
  EXPECT_THROW(sim.add_robot(bad, {1, 1, 0}), std::invalid_argument);
}

TEST(Submarine, RunsAreTheSameInEveryBuild) {
  Rig rig(submarine(), {1.0, 1.0, 0.3});
  run_motors(rig, 0.7, -0.9, 0.5, -0.3);
  rig.steps(400);
  rig.sim.drive(rig.robot, {0.4, 1.0, 0.3});
  rig.finish();
  EXPECT_EQ(rig.sim.state_hash(), 18072011191410415888u);
}

}  // namespace
}  // namespace eyebridge::robot
