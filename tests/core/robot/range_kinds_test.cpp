// Ultrasound and infrared: what they make of walls, against what geometry says.
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"
#include "rig.hpp"
#include "sensing.hpp"
#include "trail.hpp"

namespace eyebridge::robot {
namespace {

constexpr double kHearing = 5e-5;  // of the range: half a degree beside a wall's nearest point
constexpr double kNone = 9.999;

RangeSensorModel sonar(double beam_deg = 30, double critical_deg = 25) {
  RangeSensorModel model;
  model.kind = RangeKind::Ultrasound;
  model.max_range = 5.0;
  model.ultrasound = {deg_to_rad(beam_deg), deg_to_rad(critical_deg)};
  return model;
}

RangeSensorModel sharp() {
  RangeSensorModel model;
  model.kind = RangeKind::Infrared;
  model.min_range = 0.1;
  model.max_range = 0.8;
  return model;
}

RobotModel with(std::vector<RangeSensorModel> sensors) {
  RobotModel model;
  model.range_sensors = std::move(sensors);
  return model;
}

/// One long wall at x = 4 and nothing else.
std::shared_ptr<const world::WorldModel> one_wall() {
  auto model = std::make_shared<world::WorldModel>();
  model->width = model->height = 20;
  model->walls.resize(1);
  model->walls[0].a = {4, -100};
  model->walls[0].b = {4, 100};
  return model;
}

/// What `sensor` reads 2 m before that wall, looking `degrees` aside of its normal.
double aside(const RangeSensorModel& sensor, double degrees) {
  Simulation sim(one_wall(), {});
  return sim.read_range(sim.add_robot(with({sensor}), {2, 2, deg_to_rad(degrees)}), 0);
}

TEST(Ultrasound, ReadsTheNearestPointOfAWallThatIsInItsCone) {
  for (const double degrees : {0.0, 3.3, -9.7, 15.0}) {
    EXPECT_NEAR(aside(sonar(), degrees), 2.0, 2 * kHearing) << degrees;
    EXPECT_NEAR(aside(sonar(30, 0), degrees), 2.0, 2 * kHearing) << degrees << ", a mirror";
  }
}

TEST(Ultrasound, HearsASlantedWallByTheRimOfItsConeUpToTheCriticalAngle) {
  for (const double degrees : {20.0, 32.5, 39.9}) {
    const double expected = 2 / std::cos(deg_to_rad(degrees - 15));
    EXPECT_NEAR(aside(sonar(), degrees), expected, expected * kHearing) << degrees;
    EXPECT_NEAR(aside(sonar(), -degrees), expected, expected * kHearing) << degrees;
  }
  EXPECT_EQ(aside(sonar(), 40.5), kNone);
  EXPECT_EQ(aside(sonar(30, 0), 16), kNone);
  EXPECT_NEAR(aside(sonar(30, 90), 40.5), 2 / std::cos(deg_to_rad(25.5)), 2e-4) << "a rough wall";
}

TEST(Ultrasound, WithoutAWidthIsARayThatKnowsMirrors) {
  EXPECT_NEAR(aside(sonar(0, 25), 20), 2 / std::cos(deg_to_rad(20)), 1e-9);
  EXPECT_EQ(aside(sonar(0, 25), 26), kNone);
}

TEST(Ultrasound, HearsAThingBesideItsAxisThatARayPassesBy) {
  Simulation sim(one_wall(), {});
  RangeSensorModel ray;
  const RobotIndex robot = sim.add_robot(with({sonar(), ray}), {2, 2, 0});
  const Vec2 place = Vec2{2, 2} + 1.0 * Heading::from_angle(deg_to_rad(12)).forward();
  RobotModel other;
  other.diameter = 0.2;
  sim.add_robot(other, {place.x, place.y, 0});
  EXPECT_NEAR(sim.read_range(robot, 0), 0.9, 1e-9);
  EXPECT_NEAR(sim.read_range(robot, 1), 2.0, 1e-9);
}

TEST(Ultrasound, OnlyThePartOfTheConeIsLostThatAMirrorCovers) {
  // A wall at 60 degrees to the axis, 1 m ahead, covers the left half of the cone.
  auto model = std::make_shared<world::WorldModel>(*one_wall());
  world::Wall mirror;
  mirror.a = {3, 2.0001};
  mirror.b = mirror.a + 2.0 * Heading::from_angle(deg_to_rad(30)).forward();
  model->walls.push_back(mirror);
  Simulation sim(model, {});
  const RobotIndex robot = sim.add_robot(with({sonar(), sonar(30, 90)}), {2, 2, 0});
  EXPECT_NEAR(sim.read_range(robot, 0), 2.0, 2 * kHearing) << "the wall behind";
  EXPECT_LT(sim.read_range(robot, 1), 1.1) << "were it rough";
}

TEST(Ultrasound, DoesNotHearWhatIsNearerThanItListensButWhatIsBehind) {
  RangeSensorModel deaf = sonar(16);
  deaf.min_range = 0.5;
  Simulation sim(one_wall(), {});
  const RobotIndex robot = sim.add_robot(with({sonar(), deaf}), {2, 2, 0});
  RobotModel other;
  other.diameter = 0.1;
  sim.add_robot(other, {2.3, 2, 0});
  EXPECT_NEAR(sim.read_range(robot, 0), 0.25, 1e-9);
  EXPECT_EQ(sim.read_range(robot, 1), kNone) << "it is all in the shadow";
  const RobotIndex beside = sim.add_robot(with({deaf}), {2, 6, 0});
  sim.add_robot(other, {2.3, 6.09, 0});
  EXPECT_NEAR(sim.read_range(beside, 0), 2.0, 1e-3) << "past the shadow";
}

TEST(Ultrasound, ReadsOutOfRangeWhereNothingIsInReach) {
  RangeSensorModel blind = sonar();
  blind.max_range = 1.9;
  EXPECT_EQ(aside(blind, 0), kNone);
  EXPECT_EQ(aside(sonar(), 180), kNone);
}

TEST(Infrared, ReadsExactlyFromItsFoldOn) {
  for (const double range : {0.1, 0.15, 0.5, 0.79}) EXPECT_EQ(folded_range(range, sharp()), range);
  Rig rig(with({sharp()}), {3.5, 2, 0});
  EXPECT_NEAR(rig.sim.read_range(rig.robot, 0), 0.5, 1e-12);
  rig.sim.set_pose(rig.robot, {3.0, 2, 0});
  EXPECT_EQ(rig.sim.read_range(rig.robot, 0), kNone) << "beyond its reach";
}

TEST(Infrared, ReadsNearerThingsAsFartherOnes) {
  const RangeSensorModel model = sharp();
  // The signal where it touches is 0.3 of the greatest one, 1 / (0.1 + 0.0042).
  EXPECT_NEAR(folded_range(0.0, model), (0.1 + 0.0042) / 0.3 - 0.0042, 1e-12);
  // Half way to the fold it is 0.65 of it.
  EXPECT_NEAR(folded_range(0.05, model), (0.1 + 0.0042) / 0.65 - 0.0042, 1e-12);
  double before = folded_range(0.0, model);
  for (double range = 0.001; range < 0.1; range += 0.001) {
    const double reading = folded_range(range, model);
    ASSERT_LT(reading, before) << range;
    ASSERT_GE(reading, 0.1) << range;
    before = reading;
  }
  EXPECT_NEAR(folded_range(0.1 - 1e-12, model), 0.1, 1e-9) << "no gap at the fold";
  RangeSensorModel ahead = model;
  ahead.pose_in_robot.x = 0.1;
  Rig rig(with({ahead}), {3.85, 2, 0});
  EXPECT_NEAR(rig.sim.read_range(rig.robot, 0), folded_range(0.05, model), 1e-9);
  EXPECT_NEAR(rig.sim.true_range(rig.robot, 0), folded_range(0.05, model), 1e-9);
}

TEST(Infrared, WithoutASignalOnContactReadsOutOfRangeThere) {
  RangeSensorModel model = sharp();
  model.infrared.contact = 0;
  EXPECT_EQ(folded_range(0.0, model), std::numeric_limits<double>::infinity());
  model.pose_in_robot.x = 0.1;
  Rig rig(with({model}), {3.899, 2, 0});
  EXPECT_EQ(rig.sim.read_range(rig.robot, 0), kNone);
}

TEST(RangeKinds, ReadingAllAtOnceIsReadingOneByOne) {
  std::vector<RangeSensorModel> sensors = {RangeSensorModel{}, sonar(), sharp(), sonar(20, 60)};
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    sensors[i].pose_in_robot.theta = 0.4 * static_cast<double>(i);
    sensors[i].error = {{0.01, 0.02, 0.01}, 0.1, false, 0.2, 0.01};
  }
  Rig one(with(sensors), {3.4, 2.1, 0.2});
  Rig all(with(sensors), {3.4, 2.1, 0.2});
  for (int round = 0; round < 20; ++round) {
    std::vector<double> expected;
    for (std::size_t i = 0; i < sensors.size(); ++i) {
      expected.push_back(one.sim.read_range(one.robot, i));
    }
    std::vector<double> ranges(sensors.size());
    all.sim.read_ranges(all.robot, ranges);
    ASSERT_EQ(ranges, expected);
  }
}

TEST(RangeKinds, ReadingAllRobotsIsReadingOneAfterTheOther) {
  std::vector<RangeSensorModel> kinds = {RangeSensorModel{}, sonar(), sharp()};
  // Pairs of rays that look equally far: more fans than are cast at once, of one robot.
  std::vector<RangeSensorModel> rays(40);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    rays[i].pose_in_robot = {i % 4 < 2 ? 0.02 : 0.03, 0.0, 0.3 * static_cast<double>(i)};
    rays[i].max_range = i % 4 < 2 ? 3.0 : 4.0;
    rays[i].error = {{0.01, 0.02, 0.01}};
  }
  std::vector<RangeSensorModel> few(8);
  for (std::size_t i = 0; i < few.size(); ++i) {
    few[i].pose_in_robot.theta = 0.7 * static_cast<double>(i);
  }
  // Around the rim, as most robots have them, all of them straight outward or not.
  std::vector<RangeSensorModel> rim(8);
  std::vector<RangeSensorModel> askew(8);
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const double bearing = kPi / 4 * static_cast<double>(i);
    rim[i].pose_in_robot = {0.09 * std::cos(bearing), 0.09 * std::sin(bearing), bearing};
    askew[i].pose_in_robot = rim[i].pose_in_robot;
    askew[i].pose_in_robot.theta += 0.2 * static_cast<double>(i);
  }
  const std::vector<RangeSensorModel>* const types[] = {&few, &rim,  &askew, &kinds,
                                                        &rim, &rays, &few};
  Simulation one(one_wall(), {});
  Simulation all(one_wall(), {});
  std::vector<std::size_t> counts;
  for (int i = 0; i < 60; ++i) {
    const auto& sensors = *types[i % 7];
    const int row = i / 8;
    const bool has_none = i % 13 == 12;
    const RobotModel model = with(has_none ? std::vector<RangeSensorModel>{} : sensors);
    counts.push_back(model.range_sensors.size());
    for (Simulation* sim : {&one, &all}) {
      sim->add_robot(model, {0.4 + 0.45 * (i % 8), 0.5 + 0.7 * row, 0.1 * i});
    }
  }
  for (Simulation* sim : {&one, &all}) sim->remove_robot(9);
  std::size_t sensors = 0;
  for (const std::size_t count : counts) sensors += count;
  std::vector<double> ranges(sensors);
  for (int round = 0; round < 5; ++round) {
    all.read_all_ranges(ranges);
    auto at = ranges.begin();
    for (RobotIndex robot = 0; robot < counts.size(); ++robot) {
      for (std::size_t i = 0; i < counts[robot]; ++i, ++at) {
        if (robot == 9) continue;
        ASSERT_EQ(*at, one.read_range(robot, i)) << "robot " << robot << ", sensor " << i;
      }
    }
    for (Simulation* sim : {&one, &all}) {
      sim->set_pose(static_cast<RobotIndex>(round), {0.3 + 0.1 * round, 8.0, 1.0});
    }
  }
  EXPECT_THROW(all.read_all_ranges(std::span(ranges).first(3)), std::out_of_range);
}

TEST(RangeKinds, RobotsOfTwoTypesWithTheSamePlacesDoNotShareThem) {
  Simulation sim(one_wall(), {});
  RangeSensorModel ray = sonar();
  ray.kind = RangeKind::Ray;
  const RobotIndex first = sim.add_robot(with({ray}), {2, 2, deg_to_rad(10)});
  const RobotIndex second = sim.add_robot(with({sonar()}), {2, 6, deg_to_rad(10)});
  const RobotIndex third = sim.add_robot(with({sonar(10)}), {2, 10, deg_to_rad(10)});
  std::vector<double> range(1);
  sim.read_ranges(first, range);
  EXPECT_NEAR(range[0], 2 / std::cos(deg_to_rad(10)), 1e-12);
  sim.read_ranges(second, range);
  EXPECT_NEAR(range[0], 2, 2 * kHearing);
  sim.read_ranges(third, range);
  EXPECT_NEAR(range[0], 2 / std::cos(deg_to_rad(5)), 1e-9);
}

TEST(RangeKinds, WhatCannotBeIsRefused) {
  const auto refused = [](const RangeSensorModel& sensor) {
    Simulation sim(one_wall(), {});
    EXPECT_THROW(sim.add_robot(with({sensor}), {2, 2, 0}), std::invalid_argument);
    EXPECT_EQ(sim.robot_count(), 0u);
  };
  refused(sonar(181));
  refused(sonar(-1));
  refused(sonar(30, 91));
  refused(sonar(std::nan("")));
  RangeSensorModel curve = sharp();
  curve.infrared.contact = 1.1;
  refused(curve);
  curve.infrared = {-0.01, 0.3};
  refused(curve);
}

struct Readings {
  std::uint64_t hash = 0;  ///< Of all.
  std::string trail;       ///< Of the first robot: its ranges and its turning.
};

Readings erring_readings() {
  std::vector<RangeSensorModel> sensors = {sonar(), sharp(), sonar(55, 40)};
  for (RangeSensorModel& sensor : sensors) {
    sensor.error = {{0.001, 0.01, 0.01}, 0.02, false, 0.1, 0.02};
  }
  sensors[1].pose_in_robot.theta = 1.2;
  RobotModel model = with(sensors);
  model.gyroscope_error = {{0.01, 0.02, 0.03}, 0.004};
  model.accelerometer_error.sigma = 0.1;
  Simulation sim(room(3, 3), {});
  for (int i = 0; i < 3; ++i) {
    sim.set_speed(sim.add_robot(model, {0.6 + 0.8 * i, 1.0 + 0.4 * i, 2.1 * i}), {0.15, 0.9});
  }
  StateHash hash;
  Readings readings;
  for (int step = 0; step < 600; ++step) {
    sim.step();
    for (RobotIndex robot = 0; robot < 3; ++robot) {
      std::array<double, 3> ranges{};
      for (std::size_t i = 0; i < 3; ++i) hash.add(ranges.at(i) = sim.read_range(robot, i));
      const Vec2 felt = sim.read_accelerometer(robot);
      const double turning = sim.read_gyroscope(robot);
      hash.add(turning + felt.x + felt.y);
      if (robot != 0 || step % 120 != 0) continue;
      readings.trail += trail_line(step, ranges[0], ranges[1], ranges[2], turning);
    }
  }
  readings.hash = hash.value();
  return readings;
}

TEST(RangeKinds, ErringReadingsAreTheSameEachTimeAndInEveryBuild) {
  const Readings readings = erring_readings();
  EXPECT_EQ(readings.hash, erring_readings().hash);
  EXPECT_EQ(readings.trail,
            "0: 2.4085830911965274 9.999 0.815878978530851 0.0641775532946448\n"
            "120: 1.9575088016075397 9.999 0.583667470301954 0.8850445098811835\n"
            "240: 1.8065763529601933 0.7092437432257584 0.8054013129425173 0.9758954281469504\n"
            "360: 0.6047152487255946 9.999 0.5641467301408429 0.9107463763151206\n"
            "480: 1.2673679266064908 9.999 0.285747518841013 0.8751498175063713\n");
}

TEST(CrossTalk, IsBetweenSensorsThatLookAtTheSameWallsOrAtEachOther) {
  Simulation sim(one_wall(), {});
  RangeSensorModel left = sonar();
  left.pose_in_robot.theta = deg_to_rad(29);
  RangeSensorModel back = sonar();
  back.pose_in_robot.theta = kPi;
  const RobotIndex robot =
      sim.add_robot(with({sonar(), left, back, RangeSensorModel{}}), {2, 2, 0});
  EXPECT_EQ(sim.cross_talkers(robot, 0), 1u) << "its neighbour";
  EXPECT_EQ(sim.cross_talkers(robot, 2), 0u);
  EXPECT_EQ(sim.cross_talkers(robot, 3), 0u) << "a ray hears nothing";
  const RobotIndex behind = sim.add_robot(with({sonar()}), {0.5, 2, 0});
  EXPECT_EQ(sim.cross_talkers(robot, 2), 1u) << "face to face";
  EXPECT_EQ(sim.cross_talkers(behind, 0), 1u);
  sim.set_pose(behind, {0.5, 2, 1.0});
  EXPECT_EQ(sim.cross_talkers(robot, 2), 0u) << "turned away";
  sim.set_pose(behind, {-3.1, 2, 0.0});
  EXPECT_EQ(sim.cross_talkers(robot, 2), 0u) << "too far away";
  sim.set_pose(behind, {6.0, 2, kPi});
  EXPECT_EQ(sim.cross_talkers(robot, 0), 1u) << "behind the wall: only the neighbour is left";
}

TEST(CrossTalk, CannotReachThroughAnotherRobot) {
  Simulation sim(one_wall(), {});
  const RobotIndex robot = sim.add_robot(with({sonar()}), {0, 2, 0});
  sim.add_robot(with({sonar()}), {2, 2, kPi});
  EXPECT_EQ(sim.cross_talkers(robot, 0), 1u);
  sim.add_robot(RobotModel{}, {1, 2, 0});
  EXPECT_EQ(sim.cross_talkers(robot, 0), 0u);
}

TEST(CrossTalk, MakesReadingsShorterAndNeverLonger) {
  RangeSensorModel noisy = sonar();
  noisy.error.cross_talk = 0.5;
  Simulation sim(one_wall(), {});
  const RobotIndex robot = sim.add_robot(with({noisy}), {2, 2, 0});
  const double alone = sim.read_range(robot, 0);
  EXPECT_EQ(alone, sim.true_range(robot, 0)) << "nobody talks";
  RobotModel small = with({sonar()});
  small.diameter = 0.01;
  sim.add_robot(small, {3.9, 2.4, deg_to_rad(193)});
  ASSERT_EQ(sim.cross_talkers(robot, 0), 1u);
  const double echo = sim.true_range(robot, 0);
  int shorter = 0;
  for (int i = 0; i < 1000; ++i) {
    const double range = sim.read_range(robot, 0);
    ASSERT_LE(range, echo);
    shorter += range < echo ? 1 : 0;
  }
  // Half of the pulses fall into the window, and those before the echo are heard.
  EXPECT_NEAR(shorter / 1000.0, 0.5 * echo / 5.0, 0.05);
}

}  // namespace
}  // namespace eyebridge::robot
