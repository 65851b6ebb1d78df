// What a robot program reaches behind machine code on an emulated Cortex-M3.
#include <cmath>
#include <csignal>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include "cortex_rig.hpp"
#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/math.hpp"
#include "eyebridge/base/unique_fd.hpp"

namespace eyebridge::mps2 {
namespace {

using ::testing::HasSubstr;

struct Dialect {
  const char* name;
  bool binary, verbose, lsb, prompt;
};
void PrintTo(const Dialect& dialect, std::ostream* out) { *out << dialect.name; }

class CortexDialects : public ::testing::TestWithParam<Dialect> {};

TEST_P(CortexDialects, TheProbeFindsTheBoardAndReadsWhatThePlantSays) {
  const Dialect& row = GetParam();
  eb_config config = dialect(true);
  config.io7.binary = row.binary;
  config.io7.verbose = row.verbose;
  config.io7.lsb_first = row.lsb;
  config.io7.prompt[0] = row.prompt ? '>' : '\0';
  CortexRig cortex(config);
  const hal::Rig rig = cortex.open("io7vw");
  const eb_pins pins = cortex.pins();
  for (const int id : {1, 2, 3, 4}) {
    EXPECT_EQ(rig.backend->range_sensor(id)->read_raw().value(), pins.psd[id - 1]) << id;
  }
  EXPECT_NE(pins.psd[0], 0);
  EXPECT_NEAR(rig.backend->range_sensor(1)->read().value(), 2.5, 0.005);
  EXPECT_NEAR(rig.backend->range_sensor(2)->read().value(), 1.0, 0.002);
}

INSTANTIATE_TEST_SUITE_P(All, CortexDialects,
                         ::testing::Values(Dialect{"Default", false, false, false, false},
                                           Dialect{"Verbose", false, true, false, true},
                                           Dialect{"LsbFirst", false, false, true, false},
                                           Dialect{"Binary", true, false, false, false},
                                           Dialect{"BinaryLsbPrompt", true, false, true, true}),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(Cortex, EncodersCountWhatTheWheelsDo) {
  CortexRig cortex(dialect(false));
  const hal::Rig rig = cortex.open("io7");
  ASSERT_NE(rig.backend->motor(1), nullptr);
  ASSERT_NE(rig.backend->motor(2), nullptr);
  ASSERT_TRUE(rig.backend->motor(1)->set_speed(1000));
  ASSERT_TRUE(rig.backend->motor(2)->set_speed(2000));
  ASSERT_TRUE(cortex.wait_for(
      [](robot::Simulation& simulation) { return simulation.encoder_ticks(0, 0) > 700; }));
  rig.backend->stop();
  ASSERT_TRUE(cortex.wait_for(
      [](robot::Simulation& simulation) { return simulation.twist(0) == Twist{}; }));
  const eb_pins pins = cortex.pins();
  // The board samples its counters once a period: what it tells may be that old.
  const auto tells = [&](int id) {
    const Time end = rig.backend->clock().now() + from_seconds(60);
    int ticks = rig.backend->encoder(id)->read().value();
    while (ticks != pins.encoder[id - 1] && rig.backend->clock().now() < end) {
      ticks = rig.backend->encoder(id)->read().value();
    }
    return ticks;
  };
  EXPECT_EQ(tells(1), pins.encoder[0]);
  EXPECT_EQ(tells(2), pins.encoder[1]);
  EXPECT_GT(pins.encoder[0], 700);
  EXPECT_NEAR(pins.encoder[1], 2 * pins.encoder[0], 0.1 * pins.encoder[1]);
}

class CortexDrives : public ::testing::TestWithParam<bool> {};

TEST_P(CortexDrives, AStraightAndATurnEndWhereTheyShould) {
  const bool on_board = GetParam();
  CortexRig cortex(dialect(on_board));
  const hal::Rig rig = cortex.open(on_board ? "io7vw" : "io7");
  const Pose start = cortex.pose();

  ASSERT_TRUE(rig.backend->drive()->start({.distance = 0.6, .angle = 0, .speed = 0.3}));
  EXPECT_EQ(rig.wait_for_drive().progress, hal::DriveProgress::Done);
  const Pose there = cortex.pose();
  EXPECT_NEAR(there.x - start.x, 0.6, 0.012);
  EXPECT_NEAR(there.y - start.y, 0, 0.012);
  EXPECT_NEAR(rig.backend->drive()->odometry().value().x, 0.6, 0.012);

  ASSERT_TRUE(rig.backend->drive()->start({.distance = 0, .angle = kPi / 2, .speed = kPi / 2}));
  EXPECT_EQ(rig.wait_for_drive().progress, hal::DriveProgress::Done);
  EXPECT_NEAR(wrap_angle(cortex.pose().theta - there.theta), kPi / 2, 0.02 * kPi / 2);
}

INSTANTIATE_TEST_SUITE_P(Both, CortexDrives, ::testing::Bool(),
                         [](const auto& row) { return row.param ? "OnBoard" : "OnHost"; });

TEST(Cortex, TheWatchdogStopsTheMotorsWhenTheProgramFallsSilent) {
  eb_config config = dialect(true);
  config.silence_us = 300'000;
  CortexRig cortex(config);
  const UniqueFd host(::open(cortex.device().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC));
  ASSERT_TRUE(host.valid());
  const Pose start = cortex.pose();
  const std::string go = "m 1 30\rm 2 30\r";
  ASSERT_EQ(::write(host.get(), go.data(), go.size()), static_cast<ssize_t>(go.size()));
  ASSERT_TRUE(cortex.wait_for(
      [](robot::Simulation& simulation) { return simulation.twist(0).linear > 0.1; }));
  ASSERT_TRUE(cortex.wait_for(
      [](robot::Simulation& simulation) { return simulation.twist(0) == Twist{}; }));
  // The world's time is the firmware's: it drove for 300 ms, however busy this machine is.
  const robot::DriveModel drive;
  const double speed = 0.3 * drive.max_wheel_speed * drive.wheel_diameter / 2;
  EXPECT_NEAR(cortex.pose().x - start.x, 0.3 * speed, 0.03 * speed);
}

TEST(Cortex, AHostThatGoesAwayStopsTheMotorsAtOnceAndTheNextOneFindsTheBoard) {
  eb_config config = dialect(true);
  config.silence_us = 0;  // no watchdog: only the loss can stop it
  CortexRig cortex(config);
  const double start = cortex.pose().x;
  {
    const UniqueFd host(::open(cortex.device().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC));
    const std::string go = "m 1 30\rm 2 30\r";
    ASSERT_EQ(::write(host.get(), go.data(), go.size()), static_cast<ssize_t>(go.size()));
    ASSERT_TRUE(cortex.wait_for(
        [](robot::Simulation& simulation) { return simulation.twist(0).linear > 0.1; }));
  }
  EXPECT_TRUE(cortex.wait_for(
      [](robot::Simulation& simulation) { return simulation.twist(0) == Twist{}; }));
  EXPECT_LT(cortex.pose().x - start, 1.58);  // the wall, which stops it, too, is farther away
  const hal::Rig rig = cortex.open("io7vw");
  EXPECT_EQ(rig.backend->range_sensor(1)->read_raw().value(), cortex.pins().psd[0]);
}

TEST(Cortex, AnEmulatorThatIsKilledIsAnErrorAtTheDevices) {
  CortexRig cortex(dialect(true));
  const hal::Rig rig = cortex.open("io7vw");
  hal::RangeSensor* psd = rig.backend->range_sensor(1);
  ASSERT_TRUE(psd->read_raw());
  ASSERT_EQ(::kill(cortex.pid(), SIGKILL), 0);
  EXPECT_EQ(cortex.wait_for_end(),
            "the emulated board is gone: qemu-system-arm was killed by signal 9");
  const auto lost = psd->read_raw();
  ASSERT_FALSE(lost);
  EXPECT_EQ(lost.error().code, Errc::Disconnected);
  EXPECT_THAT(lost.error().what, HasSubstr(cortex.device()));
  EXPECT_FALSE(rig.backend->motor(1)->set_duty(0.1));
}

}  // namespace
}  // namespace eyebridge::mps2
