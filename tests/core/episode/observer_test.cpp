// What a controller sees, as a row of numbers.

#include "eyebridge/episode/observer.hpp"

#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/episode/episode.hpp"
#include "rooms.hpp"

namespace eyebridge::episode {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;

std::vector<double> observe(Episode& episode, const std::string& words) {
  const Observer observer(words, episode.simulation().model(0));
  std::vector<double> row(observer.size(), -1);
  observer.read(episode.simulation(), 0, row);
  return row;
}

std::string refusal(const std::string& words, const robot::RobotModel& model) {
  try {
    const Observer observer(words, model);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Observer, ReadsWhatItsWordsSayInTheirOrder) {
  Episode episode(room());
  episode.simulation().set_pose(0, {0.8, 1.0, 0.5});
  const std::vector<double> row = observe(episode, "compass pose  psd");
  ASSERT_EQ(row.size(), 1 + 3 + 8U);
  EXPECT_NEAR(row[0], 0.5, 1e-12);
  EXPECT_THAT(std::vector(row.begin() + 1, row.begin() + 4),
              ElementsAre(0.8, 1.0, DoubleNear(0.5, 1e-12)));
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(row[4 + i], episode.simulation().true_range(0, i));
  }
}

TEST(Observer, ReadsDistanceSensorsInTheOrderOfTheirNumbers) {
  robot::RobotModel model = *files::builtin_robot("S4");
  std::swap(model.range_sensors[0], model.range_sensors[3]);
  auto scenario = room();
  scenario->models[0] = model;
  Episode episode(scenario);
  episode.simulation().set_pose(0, {0.3, 1.0, 0.0});
  const std::vector<double> row = observe(episode, "psd");
  EXPECT_GT(row[0], 1.5) << "PSD 1 looks ahead, into the room";
  EXPECT_LT(row[3], 0.3) << "PSD 4 looks back, at the wall";
}

TEST(Observer, ALidarHasAsManyRaysAsAreAskedFor) {
  Episode episode(room());
  EXPECT_EQ(observe(episode, "lidar").size(), 360U);
  const std::vector<double> four = observe(episode, "lidar:4");
  ASSERT_EQ(four.size(), 4U);
  for (const double range : four) EXPECT_NEAR(range, 0.995, 1e-6) << "in the middle of 2 m x 2 m";
}

TEST(Observer, SpeedIsWhatTheWheelsDo) {
  Episode episode(room());
  episode.simulation().set_speed(0, {0.2, 0.5});
  episode.run(1);
  EXPECT_THAT(observe(episode, "speed"), ElementsAre(DoubleNear(0.2, 1e-9), DoubleNear(0.5, 1e-9)));
  EXPECT_GT(observe(episode, "odometry")[0], 0.1);
}

TEST(Observer, GyroscopeAndAccelerometerFeelTheMotion) {
  Episode episode(room());
  EXPECT_THAT(observe(episode, "gyroscope accelerometer"), ElementsAre(0, 0, 0));
  episode.simulation().set_speed(0, {0.2, 0.5});
  episode.run(1);
  EXPECT_THAT(observe(episode, "accelerometer gyroscope"),
              ElementsAre(DoubleNear(0, 1e-9), DoubleNear(0.1, 1e-9), DoubleNear(0.5, 1e-9)));
  const Observer observer("gyroscope accelerometer", *files::builtin_robot("S4"));
  EXPECT_EQ(observer.size(), 3U);
  EXPECT_TRUE(std::isinf(observer.high()[2]));
}

TEST(Observer, BumpersAreZeroOrOne) {
  auto scenario = room();
  scenario->models[0].bumpers = {{1, "front", -1.0, 1.0}, {2, "back", 2.0, -2.0}};
  Episode episode(scenario);
  EXPECT_THAT(observe(episode, "bumper"), ElementsAre(0, 0));
  episode.simulation().set_speed(0, {0.5, 0.0});
  episode.run(5);
  EXPECT_THAT(observe(episode, "bumper"), ElementsAre(1, 0));
}

TEST(Observer, KnowsTheBoundsOfItsNumbers) {
  const Observer observer("psd compass speed", *files::builtin_robot("S4"));
  ASSERT_EQ(observer.size(), 8 + 1 + 2U);
  EXPECT_EQ(observer.low()[0], 0.0);
  EXPECT_EQ(observer.high()[0], 9.999);
  EXPECT_NEAR(observer.high()[8], 3.14159, 1e-5);
  EXPECT_TRUE(std::isinf(observer.high()[9]));
}

TEST(Observer, RefusesWhatTheRobotDoesNotHave) {
  robot::RobotModel bare;
  EXPECT_EQ(refusal("psd", bare),
            "found 'psd' for an observation, expected a robot with distance sensors");
  EXPECT_NE(refusal("lidar", bare), "");
  EXPECT_NE(refusal("bumper", bare), "");
}

TEST(Observer, RefusesWordsThatCannotBe) {
  const robot::RobotModel& s4 = *files::builtin_robot("S4");
  EXPECT_NE(refusal("", s4), "");
  EXPECT_NE(refusal("  ", s4), "");
  EXPECT_EQ(refusal("pds", s4),
            "found 'pds' for an observation, expected psd, lidar, lidar:N, bumper, compass, "
            "gyroscope, accelerometer, speed, odometry or pose");
  for (const char* bad : {"lidar:", "lidar:0", "lidar:x", "lidar:5x", "lidar:36001", "lidar:-1"}) {
    EXPECT_EQ(refusal(bad, s4), "found '" + std::string(bad) +
                                    "' for an observation, expected lidar:1 ... lidar:36000");
  }
  EXPECT_EQ(refusal("psd lidar:3 psd", s4),
            "found 'psd' for an observation, expected each observation once");
  EXPECT_NE(refusal("lidar lidar:8", s4), "");
}

}  // namespace
}  // namespace eyebridge::episode
