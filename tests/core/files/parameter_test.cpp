#include <gmock/gmock.h>

#include "eyebridge/base/units.hpp"
#include "reading.hpp"

namespace eyebridge::files {
namespace {

std::vector<Warning> parameter_warnings;

ParameterFile parameter_of(const std::string& text) {
  parameter_warnings.clear();
  return read_parameter_file(text, "eyesim.p", parameter_warnings);
}

TEST(Parameters, ReadsEveryKeyword) {
  const auto file = parameter_of(
      "name Rookie\ndiameter 150 # mm\nspeed 40\nturn 180\nmaze demo.maz\n"
      "pause on\ndebug off\npsd PSD_LEFT -205 90 70 0\npsd PSD_FRONT -200 0 70 0\n"
      "ir IR_F -400 0 75 45\nbump BUMP_RIGHT -500 -180 0\n");
  EXPECT_EQ(file.robot.name, "Rookie");
  EXPECT_EQ(file.robot.diameter, 0.15);
  EXPECT_EQ(file.robot.drive.max_linear, 0.4);
  EXPECT_EQ(file.robot.drive.max_angular, kPi);
  EXPECT_EQ(file.maze, "demo.maz");
  EXPECT_FALSE(file.world);
  EXPECT_TRUE(file.pause);
  EXPECT_FALSE(file.debug);
  ASSERT_EQ(file.robot.range_sensors.size(), 2u);
  EXPECT_EQ(file.robot.range_sensors[0].id, 2);
  EXPECT_NEAR(file.robot.range_sensors[0].pose_in_robot.y, 0.07, 1e-12);
  EXPECT_NEAR(file.robot.range_sensors[0].pose_in_robot.theta, kPi / 2, 1e-12);
  EXPECT_EQ(file.robot.range_sensors[1].id, 1);
  EXPECT_EQ(file.robot.proximity_sensors.at(0).id, 1);
  EXPECT_NEAR(file.robot.proximity_sensors.at(0).pose_in_robot.theta, kPi / 4, 1e-12);
  EXPECT_EQ(file.robot.bumpers.at(0).start, -kPi);
  EXPECT_EQ(parameter_warnings.size(), 3u);  // one for each kind of sensor that was renumbered
}

TEST(Parameters, KnowsOurErrorModels) {
  EXPECT_EQ(parameter_of("psd A 1 0 0 0\nerror psd 5 0\n").robot.range_sensors.at(0).error.sigma,
            0.005);
}

TEST(Parameters, EveryMistakeIsNamed) {
  const auto error = [](const std::string& text) { return error_of([&] { parameter_of(text); }); };
  EXPECT_EQ(error("name X\nspeeed 3\n"),
            "eyesim.p:2:1: unknown keyword 'speeed': expected 'speed'?");
  EXPECT_THAT(
      error("name X\n  gravity 9\n"),
      testing::HasSubstr("eyesim.p:2:3: unknown keyword 'gravity': expected name, diameter"));
  EXPECT_EQ(error("pause maybe"), "eyesim.p:1:7: 'maybe' found: expected 'on' or 'off'");
  EXPECT_EQ(error("world a.wld\nmaze b.maz"), "eyesim.p:2:1: a second world or maze: expected one");
  EXPECT_EQ(error("speed fast"), "eyesim.p:1:7: 'fast' found: expected the speed, a number");
  EXPECT_EQ(
      error("psd A 1 0 0"),
      "eyesim.p:1:12: 'psd' with 4 arguments: expected 'psd NAME id angle distance direction'");
  EXPECT_EQ(error("bump A 3 0 9\nbump B 3 0 9"),
            "eyesim.p:2:8: bump id 3 is given twice: expected every id once");
  EXPECT_THAT(error(""), testing::HasSubstr("no keyword of a parameter file"));
}

}  // namespace
}  // namespace eyebridge::files
