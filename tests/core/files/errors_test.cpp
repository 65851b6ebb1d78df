// What files and settings say about errors: rules, tables of sensors, who gets what.
#include <gmock/gmock.h>

#include "eyebridge/base/units.hpp"
#include "eyebridge/files/error_rules.hpp"
#include "reading.hpp"

namespace eyebridge::files {
namespace {

using testing::HasSubstr;

/// Two PSDs with a table, an IR, a bumper, a lidar and a camera.
robot::RobotModel full_model() {
  robot::RobotModel model;
  model.range_sensors.resize(2);
  model.range_sensors[1].id = 2;
  for (auto& sensor : model.range_sensors) sensor.table = robot::RangeTable({0.1, 0.2});
  model.proximity_sensors.resize(1);
  model.bumpers.resize(1);
  model.lidar = robot::LidarModel{};
  model.camera = robot::CameraModel{};
  return model;
}

robot::RobotModel after(const std::string& rules) {
  robot::RobotModel model = full_model();
  for (const ErrorRule& rule : read_error_rules(rules, {"--errors"})) apply_rule(rule, model);
  return model;
}

std::string error_in_rules(const std::string& rules) {
  return error_of([&] { read_error_rules(rules, {"--errors"}); });
}

TEST(ErrorRules, AValueMayHaveItsNameAndItsUnitOrNeither) {
  for (const char* same : {"psd 4 1", "psd 4mm 1%", "psd sigma=4 relative=1", "PSD Sigma=+4mm 1%",
                           "  psd\t4   relative=1% ;"}) {
    if (std::string_view(same).starts_with("PSD")) {
      EXPECT_THAT(error_in_rules(same), HasSubstr("--errors:1:16: '1%' found"))
          << "after a name all have theirs";
      continue;
    }
    const auto model = after(same);
    EXPECT_EQ(model.range_sensors[0].error, (robot::RangeError{{0.0, 0.004, 0.01}})) << same;
    EXPECT_EQ(model.range_sensors[1].error, model.range_sensors[0].error) << same;
  }
}

TEST(ErrorRules, EveryParameterGoesWhereItsNameSays) {
  const auto model = after(
      "psd bias=5 dropout=2 quantised crosstalk=30 quadratic=40; drive 1 2 slip=3; wheels 4 -5; "
      "encoder quantised miss=6;"
      "compass 90 bias=-90; camera 7 8 coloured=9 blur=1.5 exposure=-1 flicker=0.25; ir 10; bump "
      "11;"
      "lidar 12 13 bias=-14 dropout=15; radio 16 17 jitter=18 corrupt=19 range=20;"
      "gyroscope 90 18deg/s bias=-9 relative=5; accelerometer 0.5m/s2 bias=-1 relative=6");
  EXPECT_EQ(model.range_sensors[1].error,
            (robot::RangeError{{0.005, 0, 0}, 0.02, true, 0.3, 0.04}));
  EXPECT_EQ(model.drive_error, (robot::DriveError{0.01, 0.02, 0.04, -0.05, true, 0.03, 0.06}));
  EXPECT_EQ(model.compass_error, (robot::CompassError{{-kPi / 2, kPi / 2, 0}}));
  EXPECT_EQ(model.camera->error, (robot::CameraError{0.07, 8, 0.09, 1.5, -1, 0.25}));
  EXPECT_EQ(model.proximity_sensors[0].error.flip, 0.1);
  EXPECT_EQ(model.bumpers[0].error.miss, 0.11);
  EXPECT_EQ(model.lidar->error, (robot::LidarError{{-0.014, 0.012, 0.13}, 0.15}));
  EXPECT_EQ(model.gyroscope_error,
            (robot::GyroscopeError{{-kPi / 20, kPi / 2, 0.05}, deg_to_rad(18)}));
  EXPECT_EQ(model.accelerometer_error, (robot::AccelerometerError{{-1, 0.5, 0.06}}));
  EXPECT_EQ(model.radio_error, (robot::RadioError{0.16, 0.017, 0.018, 0.19, 20}));
}

TEST(ErrorRules, LaterOnesChangeWhatEarlierOnesSaid) {
  const auto model = after("harsh; psd:2 dropout=50%; psd:2 bias=1; camera salt=0");
  const robot::ErrorModels harsh = *robot::error_preset("harsh");
  EXPECT_EQ(model.range_sensors[0].error, harsh.range);
  robot::RangeError second = harsh.range;
  second.dropout = 0.5;
  second.bias = 0.001;
  EXPECT_EQ(model.range_sensors[1].error, second);
  EXPECT_EQ(model.camera->error.salt_and_pepper, 0.0);
  EXPECT_EQ(model.camera->error.sigma, harsh.camera.sigma);
  EXPECT_TRUE(robot::is_perfect(after("harsh; psd 9; perfect")));
  EXPECT_TRUE(robot::is_perfect(after("")));
}

TEST(ErrorRules, EveryMistakeIsNamedWithItsPlace) {
  const std::pair<const char*, const char*> cases[] = {
      {"realistc", "--errors:1:1: unknown error model 'realistc': expected 'realistic'?"},
      {"psi 1", "--errors:1:1: unknown error model 'psi': expected 'psd'?"},
      {"realistic now", "--errors:1:11: 'now' found after a preset: expected nothing"},
      {"harsh; psd",
       "--errors:1:11: the rule ends: expected sigma, relative, bias, dropout, "
       "quantised, crosstalk or quadratic"},
      {"robot:2", "--errors:1:8: the rule ends: expected a preset or an error model"},
      {"robot:two psd 1", "--errors:1:7: 'two' found: expected the number of a robot, 1 or more"},
      {"psd:0 1", "--errors:1:5: '0' found: expected the number of a psd, 1 or more"},
      {"lidar:1 1", "--errors:1:1: 'lidar:1' found: expected lidar alone, a robot has one"},
      {"psd 1 2 3",
       "--errors:1:9: '3' found: expected sigma, relative, bias, dropout, quantised, crosstalk or "
       "quadratic"},
      {"psd -1", "--errors:1:5: psd's sigma is -1: expected 0 to 1e+05 mm"},
      {"psd dropout=101%", "--errors:1:13: psd's dropout is 101%: expected 0 to 100 %"},
      {"psd sigma=4cm", "--errors:1:11: '4cm' found: expected psd's sigma, a number in mm"},
      {"psd sigma=nan", "--errors:1:11: 'nan' found: expected psd's sigma, a number in mm"},
      {"psd sigma=", "--errors:1:11: '' found: expected psd's sigma, a number in mm"},
      {"psd sigma", "--errors:1:5: 'sigma' found: expected sigma=a number in mm"},
      {"psd drop=1",
       "--errors:1:5: 'drop=1' found: expected sigma, relative, bias, dropout, "
       "quantised, crosstalk or quadratic"},
      {"psd sgma=1", "--errors:1:5: 'sgma=1' found: expected 'sigma'?"},
      {"encoder quantised=1", "--errors:1:9: 'quantised=1' found: expected quantised alone"},
      {"radio 1 2h", "--errors:1:9: '2h' found: expected radio's delay, a number in ms"},
  };
  for (const auto& [rules, expected] : cases) EXPECT_EQ(error_in_rules(rules), expected) << rules;
}

TEST(ErrorRules, KeepThePlaceOfAFileThatTheyAreGivenIn) {
  EXPECT_EQ(error_of([] {
              read_error_rules("psd 1; psi 2", {"eyebridge.toml", 7, 10});
            }),
            "eyebridge.toml:7:10: unknown error model 'psi': expected 'psd'?");
}

robot::RobotModel erring_robi(const std::string& text) {
  std::vector<Warning> warnings;
  return read_robi(text, "r.robi", warnings);
}
std::string erring_robi_error(const std::string& text) {
  return error_of([&] { erring_robi(text); });
}

TEST(RobotFile, TakesRulesAndATableInAnyOrder) {
  const auto robot = erring_robi(
      "error realistic\nerror psd:2 quantised dropout=5%\ndiameter 99\npsd A 1 0 0 0 0\n"
      "psd B 2 0 0 0 0\npsd_table 9999 800 400 200 100 0\n");
  const robot::ErrorModels realistic = *robot::error_preset("realistic");
  EXPECT_EQ(robot.range_sensors[0].table.levels(), (std::vector<double>{0.1, 0.2, 0.4, 0.8}));
  EXPECT_EQ(robot.range_sensors[0].error, realistic.range);
  EXPECT_EQ(robot.range_sensors[1].error.dropout, 0.05);
  EXPECT_EQ(robot.drive_error, realistic.drive);
}

TEST(RobotFile, MistakesOfRulesAndTablesHaveTheirPlace) {
  EXPECT_EQ(
      erring_robi_error("diameter 99\npsd A 1 0 0 0 0\nerror psd quantised\n"),
      "r.robi:3:7: psd 1 of robot 'S4' has no table to round to: expected a psd_table line in "
      "its file, or its table in the HDT file of --hdt");
  EXPECT_EQ(erring_robi_error("diameter 99\npsd A 1 0 0 0 0\npsd B 4 0 0 0 0\nerror psd:3 4\n"),
            "r.robi:4:7: robot 'S4' has no psd 3: expected one of 1, 4");
  EXPECT_EQ(erring_robi_error("diameter 99\nerror bump:1 4\n"),
            "r.robi:2:7: robot 'S4' has no bump 1: expected another kind, it has none of this");
  EXPECT_EQ(erring_robi_error("diameter 99\nerror\n"),
            "r.robi:2:6: line ends: expected a preset or an error model");
  EXPECT_EQ(erring_robi_error("diameter 99\nerror robot:1 harsh\n"),
            "r.robi:2:7: 'robot:1' found: this file is about one robot");
  EXPECT_EQ(erring_robi_error("psd_table 9999\n"),
            "r.robi:1:15: line ends: expected 'psd_table MM MM ...', by raw value");
  EXPECT_EQ(erring_robi_error("psd_table 9999 0\n"),
            "r.robi:1:11: no range below 9999 in the table: expected one");
  EXPECT_EQ(erring_robi_error("psd_table 100 far\n"),
            "r.robi:1:15: 'far' found: expected a range of the table, a number");
}

TEST(Sim, GivesErrorsToAllRobotsOrToOne) {
  const Folder folder;
  const auto path =
      folder.write("a.sim",
                   "error robot:2 psd:1 dropout=5%\nS4 500 500 0\nS4 1500 500 0\nS4 500 1500 0\n"
                   "error realistic\nerror robot:3 perfect\n");
  const Scenario scenario = load_scenario(path);
  const auto error_of_robot = [&](std::size_t i) {
    return scenario.models.at(scenario.robots.at(i).model).range_sensors.at(0).error;
  };
  const robot::RangeError realistic = robot::error_preset("realistic")->range;
  EXPECT_EQ(error_of_robot(0), realistic);
  EXPECT_EQ(error_of_robot(1), realistic) << "the later rule is about all";
  EXPECT_TRUE(error_of_robot(2).perfect());
}

TEST(Sim, WithoutRobotsItsErrorsAreThoseOfTheOneItGets) {
  const Folder folder;
  const Scenario scenario = load_scenario(folder.write("a.sim", "error harsh\n"));
  EXPECT_EQ(scenario.models.at(scenario.robots.at(0).model).drive_error,
            robot::error_preset("harsh")->drive);
}

TEST(Sim, MistakesAboutErrorsHaveTheirPlace) {
  const Folder folder;
  const auto error = [&](const std::string& text) {
    const auto path = folder.write("a.sim", text);
    return without(error_of([&] { load_scenario(path); }), folder.path().string() + "/");
  };
  EXPECT_EQ(error("S4 500 500 0\nerror robot:2 harsh\n"),
            "a.sim:2:7: found robot 2: expected 1 to 1");
  EXPECT_EQ(error("S4 500 500 0\nerror psd:77 1\n"),
            "a.sim:2:7: robot 'S4' has no psd 77: expected one of 1, 2, 3, 4, 5, 6, 7, 8");
  EXPECT_EQ(error("S4 500 500 0\nerror harsch\n"),
            "a.sim:2:7: unknown error model 'harsch': expected 'harsh'?");
  EXPECT_EQ(error("error\n"), "a.sim:1:6: line ends: expected a preset or an error model");
}

}  // namespace
}  // namespace eyebridge::files
