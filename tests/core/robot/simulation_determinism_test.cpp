#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "rig.hpp"
#include "trail.hpp"

namespace eyebridge::robot {
namespace {

RobotModel erring_model() {
  RobotModel model;
  model.drive.motor_time_constant = 0.04;
  model.drive_error = {0.05, 0.05, 0.01, -0.005, true};
  model.range_sensors.resize(2);
  model.range_sensors[1].pose_in_robot = {0.0, 0.05, kPi / 2};
  for (RangeSensorModel& sensor : model.range_sensors) sensor.error = {{0.001, 0.005, 0.02}};
  model.proximity_sensors.resize(1);
  model.proximity_sensors[0].error.flip = 0.05;
  model.bumpers = {{1, "front", -0.8, 0.8, {0.1}}};
  model.lidar = LidarModel{};
  model.lidar->error.sigma = 0.01;
  model.compass_error.sigma = 0.03;
  return model;
}

struct Wandering {
  std::uint64_t hash = 0;  ///< Of all readings and the end.
  std::string trail;       ///< Of the first robot: its pose.
};

/// Five robots that wander by what their faulty sensors say, for 20 s.
Wandering wander(std::uint64_t seed) {
  Wandering run;
  SimulationSettings settings;
  settings.seed = seed;
  Simulation sim(room(2.0, 2.0), settings);
  for (int i = 0; i < 5; ++i) {
    sim.add_robot(erring_model(), {0.3 + 0.3 * i, 0.4 + 0.25 * i, 0.9 * i});
  }
  StateHash readings;
  std::vector<double> scan(36);
  for (int step = 0; step < 2000; ++step) {
    sim.step();
    if (step % 20 != 0) continue;
    for (RobotIndex robot = 0; robot < 5; ++robot) {
      const double front = sim.read_range(robot, 0);
      sim.read_lidar(robot, 2 * kPi, scan);
      readings.add(front + sim.read_range(robot, 1) + scan[7] + sim.read_compass(robot));
      const bool near = sim.read_proximity(robot, 0) || sim.read_bumper(robot, 0);
      if (sim.drive_state(robot) == DriveState::Driving && !near) continue;
      if (near || front < 0.3) {
        sim.drive(robot, {-0.05, 1.0 + scan[0], 0.2});
      } else if (robot == 4) {
        sim.set_motor_speed(robot, 0, 800.0 + 100.0 * front);
        sim.set_motor_speed(robot, 1, 1000.0);
      } else {
        sim.drive(robot, {front / 2, 0.3, 0.4});
      }
    }
    if (step % 400 == 0) {
      const Pose pose = sim.pose(0);
      run.trail += trail_line(step, pose.x, pose.y, pose.theta);
    }
  }
  readings.add(sim.state_hash());
  run.hash = readings.value();
  return run;
}

TEST(Determinism, FiveErringRobotsDriveTheSameWayEachTimeAndInEveryBuild) {
  const Wandering run = wander(1);
  EXPECT_EQ(run.hash, wander(1).hash);
  EXPECT_EQ(run.trail,
            "0: 0.3 0.4 0\n"
            "400: 0.486580069554655 1.0137577684657044 1.6225362251738564\n"
            "800: 0.39826886322925514 1.7464966224015752 -0.9988138863316334\n"
            "1200: 0.7429947409220288 1.87925618104586 -1.9755314748380202\n"
            "1600: 1.1517086444345 1.552753816423326 -0.5475587614196026\n");
}

TEST(Determinism, AnotherSeedGivesAnotherRun) { EXPECT_NE(wander(1).hash, wander(2).hash); }

/// Robots that come one after the other while those that are there drive and look about; with
/// `looks`, they look more often, which changes nothing but what the simulation remembers.
std::uint64_t grow(bool looks) {
  RobotModel model;
  model.range_sensors.resize(2);
  model.lidar = LidarModel{};
  Simulation sim(room(6.0, 6.0), {});
  StateHash readings;
  std::vector<double> scan(90);
  for (int step = 0; step < 1200; ++step) {
    if (step % 40 == 0) {
      const auto robot = static_cast<double>(sim.robot_count());
      const double x = 0.3 + 0.25 * std::fmod(robot, 20.0);
      sim.set_speed(sim.add_robot(model, {x, 0.3, 1.4}), {0.1 + 0.01 * robot, 0.02 * robot});
    }
    sim.step();
    const auto count = static_cast<RobotIndex>(sim.robot_count());
    for (RobotIndex robot = 0; robot < count; ++robot) {
      if (!looks && step % 10 != 0) continue;
      sim.read_lidar(robot, 2 * kPi, scan);
      const double front = sim.read_range(robot, 0);
      if (step % 10 == 0) readings.add(front + scan[7]);
    }
  }
  EXPECT_EQ(sim.robot_count(), 30u);
  readings.add(sim.state_hash());
  return readings.value();
}

TEST(Determinism, RobotsThatComeWhileOthersDriveAreTheSameInEveryRun) {
  EXPECT_EQ(grow(false), grow(false));
  EXPECT_EQ(grow(false), grow(true));
}

TEST(Determinism, WithoutErrorsTheSeedDoesNotMatter) {
  const auto run = [](std::uint64_t seed) {
    SimulationSettings settings;
    settings.seed = seed;
    RobotModel model;
    model.range_sensors.resize(1);
    model.proximity_sensors.resize(1);
    model.bumpers = {{1, "ring", 0.0, 2 * kPi, {0.0}}};
    model.lidar = LidarModel{};
    Rig rig(model, {2.0, 2.0, 0.3}, settings);
    rig.sim.drive(rig.robot, {5.0, 3.0, 0.4});
    StateHash hash;
    std::vector<double> scan(90);
    for (int i = 0; i < 1500; ++i) {
      rig.sim.step();
      rig.sim.read_lidar(rig.robot, 2 * kPi, scan);
      hash.add(scan[3] + rig.sim.read_range(rig.robot, 0) + rig.sim.read_compass(rig.robot));
      hash.add(std::uint64_t{rig.sim.read_proximity(rig.robot, 0)});
      hash.add(std::uint64_t{rig.sim.read_bumper(rig.robot, 0)});
    }
    hash.add(rig.sim.state_hash());
    return hash.value();
  };
  EXPECT_EQ(run(1), run(2));
}

TEST(Determinism, AnotherSensorDoesNotChangeTheNoiseOfTheFirst) {
  const auto first_readings = [](std::size_t sensors) {
    RobotModel model;
    model.range_sensors.resize(sensors);
    for (RangeSensorModel& sensor : model.range_sensors) sensor.error.sigma = 0.01;
    Rig rig(model);
    std::vector<double> readings;
    for (int i = 0; i < 20; ++i) {
      readings.push_back(rig.sim.read_range(rig.robot, 0));
      for (std::size_t s = 1; s < sensors; ++s) {
        EXPECT_NE(rig.sim.read_range(rig.robot, s), readings.back());
      }
    }
    return readings;
  };
  EXPECT_EQ(first_readings(1), first_readings(3));
}

TEST(Determinism, StateHashNoticesAStep) {
  Rig rig;
  const std::uint64_t before = rig.sim.state_hash();
  EXPECT_EQ(before, rig.sim.state_hash());
  rig.sim.set_servo(rig.robot, 0, 0.6);
  EXPECT_NE(before, rig.sim.state_hash());
}

}  // namespace
}  // namespace eyebridge::robot
