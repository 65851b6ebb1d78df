// Devices that fail by a script, and scripts that are wrong.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/hal/registry.hpp"
#include "fault/fault_injector.hpp"
#include "rigs.hpp"

namespace eyebridge::hal {
namespace {

using testing::HasSubstr;

/// The robot of the rigs, 1 m before a wall, in virtual time, with broken devices.
Rig broken(const std::string& script, std::uint64_t seed = 1) {
  Rig rig = lockstep_rig(facing(1.0));
  rig.backend = with_faults(std::move(rig.backend), parse_fault_script(script, {}), seed);
  return rig;
}

TEST(Faults, LoseTheDeviceThatIsNamedForTheTimeThatIsNamed) {
  const Rig rig = broken("psd:1 lose @2s..4s");
  RangeSensor& front = *rig.backend->range_sensor(1);
  EXPECT_NEAR(front.read().value(), 1.0, 1e-9);
  rig.wait(3.0);
  EXPECT_EQ(front.read().error().code, Errc::Disconnected);
  EXPECT_THAT(front.read().error().what, HasSubstr("psd:1 lose @2s..4s"));
  EXPECT_FALSE(front.read_raw());
  EXPECT_TRUE(rig.backend->range_sensor(2)->read());
  rig.wait(1.0);
  EXPECT_TRUE(front.read());
}

TEST(Faults, LoseAllOfAKindAndAllKinds) {
  const Rig rig = broken("all lose @1s; motor lose");
  EXPECT_FALSE(rig.backend->motor(1)->set_duty(0.5));
  EXPECT_FALSE(rig.backend->motor(2)->set_pid(1, 1, 1));
  EXPECT_TRUE(rig.backend->servo(1)->set(0.5));
  rig.wait(1.0);
  EXPECT_FALSE(rig.backend->servo(1)->set(0.5));
  EXPECT_FALSE(rig.backend->encoder(1)->read());
  EXPECT_FALSE(rig.backend->drive()->set_speed({0.1, 0.0}));
  EXPECT_FALSE(rig.backend->compass()->read());
  EXPECT_FALSE(rig.backend->gyroscope()->read());
  EXPECT_FALSE(rig.backend->accelerometer()->read());
  EXPECT_FALSE(rig.backend->proximity(1)->read());
  EXPECT_FALSE(rig.backend->bumper(1)->read());
  std::vector<double> scan(8);
  EXPECT_FALSE(rig.backend->lidar()->read(scan));
}

TEST(Faults, FrozenSensorsKeepTheirReadingWhileTheRobotDrivesOn) {
  const Rig rig = broken("psd:1 freeze @1s");
  ASSERT_TRUE(rig.backend->drive()->start({0.4, 0.0, 0.2}));
  rig.wait(1.0);
  const double frozen = rig.backend->range_sensor(1)->read().value();
  EXPECT_LT(frozen, 0.95);
  EXPECT_EQ(rig.wait_for_drive().progress, DriveProgress::Done);
  EXPECT_EQ(rig.backend->range_sensor(1)->read().value(), frozen);
}

TEST(Faults, FrozenDrivesTakeCommandsWithoutMoving) {
  const Rig rig = broken("drive freeze");
  EXPECT_TRUE(rig.backend->drive()->set_speed({0.2, 0.0}));
  rig.wait(1.0);
  EXPECT_NEAR(rig.backend->range_sensor(1)->read().value(), 1.0, 1e-9);
}

TEST(Faults, AFrozenLidarHasNoScanOfAnotherShape) {
  const Rig rig = broken("lidar freeze @1s");
  std::vector<double> scan(8);
  ASSERT_TRUE(rig.backend->lidar()->read(scan));
  ASSERT_TRUE(rig.backend->lidar()->configure(1.0, 0.0, 3));
  rig.wait(1.0);
  scan.resize(3);
  EXPECT_EQ(rig.backend->lidar()->read(scan).error().code, Errc::Corrupt);
}

TEST(Faults, DelaysTakeTimeOnTheRobotsClock) {
  const Rig rig = broken("psd:1 delay 20ms; psd delay 5ms");
  const Time before = rig.backend->clock().now();
  ASSERT_TRUE(rig.backend->range_sensor(1)->read());
  EXPECT_EQ(rig.backend->clock().now() - before, std::chrono::milliseconds(25));
}

int drops(const Rig& rig, int sensor) {
  int count = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto range = rig.backend->range_sensor(sensor)->read();
    if (!range) {
      EXPECT_EQ(range.error().code, Errc::Timeout);
      ++count;
    }
  }
  return count;
}

TEST(Faults, DropTheShareThatIsSaidTheSameForTheSameSeed) {
  const int once = drops(broken("psd:1 drop 10%"), 1);
  EXPECT_NEAR(once, 100, 40);  // four standard deviations
  EXPECT_EQ(drops(broken("psd:1 drop 10%"), 1), once);
  EXPECT_NE(drops(broken("psd:1 drop 10%", 2), 1), once);
  EXPECT_EQ(drops(broken("psd:1 drop 0%"), 1), 0);
  EXPECT_EQ(drops(broken("psd:1 drop 100%"), 1), 1000);
}

TEST(Faults, AreGivenInTheConfiguration) {
  KeepingLog log;
  const auto backend =
      open_backend({rig_config({{"fast", "true"}, {"faults", "compass lose"}}), log});
  EXPECT_FALSE(backend->compass()->read());
  EXPECT_TRUE(backend->drive()->odometry());
  EXPECT_EQ(backend->range_sensor(77), nullptr);
}

std::string complaint(const std::string& script) {
  KeepingLog log;
  try {
    open_backend({rig_config({{"fast", "true"}, {"faults", script}}), log});
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(FaultScript, MistakesAreNamedWithTheirColumn) {
  EXPECT_THAT(complaint("psd:1 lose; wheel lose"), HasSubstr("--faults:1:13: found 'wheel'"));
  EXPECT_THAT(complaint("psd:0 lose"), HasSubstr("found 'psd:0', expected a device's number"));
  EXPECT_THAT(complaint("psd:x lose"), HasSubstr("found 'psd:x', expected a device's number"));
  EXPECT_THAT(complaint("psd loose"), HasSubstr("found 'loose', expected lose, freeze"));
  EXPECT_THAT(complaint("psd"), HasSubstr("found nothing, expected lose, freeze"));
  EXPECT_THAT(complaint("psd drop 10"), HasSubstr("found '10', expected a share"));
  EXPECT_THAT(complaint("psd drop nan%"), HasSubstr("found 'nan%', expected a share"));
  EXPECT_THAT(complaint("psd delay"), HasSubstr("expected a duration"));
  EXPECT_THAT(complaint("psd lose 2s"), HasSubstr("found '2s', expected a time as in @2s"));
  EXPECT_THAT(complaint("psd lose @4s..2s"), HasSubstr("expected an end after the beginning"));
  EXPECT_THAT(complaint("psd lose @1s psd"), HasSubstr("found 'psd', expected ';'"));
  EXPECT_EQ(
      complaint(" ; psd lose ;; all freeze @1s.. 2s"),
      "--faults:1:16: found '', expected a duration such as 2s, 250ms, 1.5 min or 2 (seconds)");
  EXPECT_EQ(complaint(" ; psd lose ;;"), "");
}

}  // namespace
}  // namespace eyebridge::hal
