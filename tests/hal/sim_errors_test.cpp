// The settings errors, error_scale and hdt in simulation, and changing errors while a robot runs.
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/robot/error_presets.hpp"
#include "rigs.hpp"
#include "shared/open_only.hpp"
#include "sim/open_sim.hpp"

namespace eyebridge::hal {
namespace {

using testing::HasSubstr;

const std::string kNoisyRoom = EYEBRIDGE_SOURCE_DIR "/worlds/noisy-room.sim";

robot::RobotModel model_with(const std::map<std::string, std::string>& flags) {
  const files::Scenario scenario = configured_scenario(rig_config(flags));
  return scenario.models.at(scenario.robots.at(0).model);
}

std::string error_with(const std::map<std::string, std::string>& flags) {
  try {
    model_with(flags);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ErrorSettings, WithoutThemARobotIsAsItsFileSays) {
  EXPECT_TRUE(robot::is_perfect(model_with({})));
  EXPECT_FALSE(robot::is_perfect(model_with({{"world", kNoisyRoom}})));
}

TEST(ErrorSettings, GoBeforeWhatFilesSay) {
  EXPECT_TRUE(robot::is_perfect(model_with({{"world", kNoisyRoom}, {"errors", "perfect"}})));
  const auto model = model_with({{"errors", "realistic; psd:1 dropout=5%"}});
  EXPECT_EQ(model.drive_error, robot::error_preset("realistic")->drive);
  EXPECT_EQ(model.range_sensors.at(0).error.dropout, 0.05);
}

TEST(ErrorSettings, AreScaledAllTogether) {
  const auto model = model_with({{"errors", "psd 4 1"}, {"error_scale", "25"}});
  EXPECT_EQ(model.range_sensors.at(0).error, (robot::RangeError{{0.0, 0.001, 0.0025}}));
  EXPECT_TRUE(robot::is_perfect(model_with({{"world", kNoisyRoom}, {"error_scale", "0"}})));
}

TEST(ErrorSettings, MistakesAreNamedWhereTheyWereMade) {
  EXPECT_EQ(error_with({{"errors", "harsh; psd sigma=x"}}),
            "--errors:1:18: 'x' found: expected psd's sigma, a number in mm");
  EXPECT_EQ(error_with({{"errors", "robot:4 harsh"}}),
            "--errors:1:1: found robot 4: expected 1 to 1");
  EXPECT_THAT(error_with({{"errors", "psd quantised"}}), HasSubstr("has no table to round to"));
  EXPECT_THAT(error_with({{"error_scale", "101"}}), HasSubstr("'101' for 'error_scale'"));
}

TEST(ErrorSettings, RoundByTheTablesOfTheHdtFile) {
  const auto path = std::filesystem::temp_directory_path() / "eyebridge_errors.hdt";
  std::ofstream file(path);
  file << "PSD 1 near\nTABLE near\n";
  for (int i = 0; i < 128; ++i) file << 100 + 7 * i << '\n';
  file << "END TABLE\n";
  file.close();
  const auto model = model_with({{"hdt", path.string()}, {"errors", "psd:1 quantised"}});
  std::filesystem::remove(path);
  EXPECT_EQ(model.range_sensors.at(0).table.levels().size(), 128U);
  EXPECT_EQ(model.range_sensors.at(0).table.nearest(0.115, 9.999), 0.114);
  EXPECT_TRUE(model.range_sensors.at(1).table.empty()) << "the file has one PSD";
}

/// What PSD 1 reads in `count` readings.
std::vector<double> readings(Backend& backend, int count) {
  std::vector<double> out;
  for (int i = 0; i < count; ++i) out.push_back(backend.range_sensor(1)->read().value());
  return out;
}

TEST(WorldControl, ChangesTheErrorsOfARobotThatRuns) {
  KeepingLog log;
  const Config config = rig_config({{"fast", "true"}});
  const auto backend = open_scenario(rig_scenario(0.5), {"room.wld"}, {config, log});
  const auto exact = readings(*backend, 2);
  EXPECT_EQ(exact[0], exact[1]);
  ASSERT_TRUE(backend->world()->set_errors(0, "psd:1 bias=100; psd:1 sigma=10", 0.5));
  const auto erring = readings(*backend, 200);
  double sum = 0;
  for (const double range : erring) sum += range - exact[0];
  EXPECT_NEAR(sum / 200, 0.05, 4 * 0.005 / std::sqrt(200.0));
  EXPECT_NE(erring[0], erring[1]);
  ASSERT_TRUE(backend->world()->set_errors(1, "perfect", 1.0));
  EXPECT_EQ(readings(*backend, 2), exact);
}

TEST(WorldControl, ChangesTheErrorsOfGyroscopeAndAccelerometer) {
  KeepingLog log;
  const Config config = rig_config({{"fast", "true"}});
  const auto backend = open_scenario(rig_scenario(0.5), {"room.wld"}, {config, log});
  EXPECT_EQ(backend->gyroscope()->read().value(), 0.0) << "it stands, and does not err";
  EXPECT_EQ(backend->accelerometer()->read().value(), Vec2{});
  ASSERT_TRUE(
      backend->world()->set_errors(0, "gyroscope bias=2; accelerometer bias=0.5 sigma=0.1", 1.0));
  EXPECT_NEAR(backend->gyroscope()->read().value(), deg_to_rad(2), 1e-12);
  Vec2 sum;
  for (int i = 0; i < 200; ++i) sum = sum + backend->accelerometer()->read().value();
  EXPECT_NEAR(sum.x / 200, 0.5, 4 * 0.1 / std::sqrt(200.0));
  EXPECT_NEAR(sum.y / 200, 0.5, 4 * 0.1 / std::sqrt(200.0));
  EXPECT_NE(sum.x, sum.y) << "each axis errs by itself";
}

TEST(WorldControl, RefusesErrorsThatCannotBe) {
  KeepingLog log;
  const Config config = rig_config({{"fast", "true"}});
  const auto backend = open_scenario(rig_scenario(0.5), {"room.wld"}, {config, log});
  WorldControl& world = *backend->world();
  const auto what = [&](int id, const char* rules, double share) {
    const auto result = world.set_errors(id, rules, share);
    return result ? "no error" : result.error().what;
  };
  EXPECT_THAT(what(0, "harsch", 1.0), HasSubstr("errors:1:1: unknown error model 'harsch'"));
  EXPECT_THAT(what(0, "robot:1 harsh", 1.0), HasSubstr("found robot:N"));
  EXPECT_THAT(what(0, "psd:9 sigma=1", 1.0), HasSubstr("has no psd 9"));
  EXPECT_THAT(what(3, "harsh", 1.0), HasSubstr("no robot 3"));
  EXPECT_THAT(what(0, "harsh", 1.1), HasSubstr("0 to 1"));
  EXPECT_THAT(what(0, "harsh", std::nan("")), HasSubstr("0 to 1"));
  const auto exact = readings(*backend, 2);
  EXPECT_EQ(exact[0], exact[1]) << "nothing was changed";
}

}  // namespace
}  // namespace eyebridge::hal
