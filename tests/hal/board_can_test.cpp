// A robot program's devices on a robot that is on a CAN bus.
#include "../bridges/client/can_bench.hpp"
#include "board/board_backend.hpp"
#include "board/can_link.hpp"
#include "board_peer.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::hal::testing {
namespace {

using bridges::testing::CanBench;
using ::testing::StartsWith;

class BoardCan : public CanBench {
 protected:
  void SetUp() override {
    ASSERT_TRUE(client->wait_ready(3s)) << log.text();
    auto made = std::make_unique<CanLink>(std::move(client));
    link = made.get();
    BoardTables tables = default_board_tables();
    for (BoardPsdTable& psd : tables.psds) psd.metres.clear();
    backend = std::make_unique<BoardBackend>(std::make_unique<BorrowedClock>(clock),
                                             std::move(made), tables);
    robot.clear();
  }
  /// `span` passes, as both threads would live it.
  void pass(Time span) {
    for (const Time end = clock.now() + span; clock.now() < end;) {
      link->client().pump(clock.now() + 10ms);
      backend->step();
    }
  }

  /// S_Status: 7.4 V, microphone at 0x0800, the key that is held, and the uptime, which must not go
  /// back.
  void send_status(int key) {
    const auto uptime = static_cast<int>((clock.now() - robot.started) / 100ms);
    robot.send(0x2A, {0xE4, 0x02, 0x00, 0x08, key, uptime & 0xFF, uptime >> 8, 0});
  }

  CanLink* link = nullptr;
  std::unique_ptr<BoardBackend> backend;
};

TEST_F(BoardCan, HasTheSensorsThatTheRobotTellsOf) {
  EXPECT_EQ(backend->range_sensor(1)->read().value(), 0.5);
  EXPECT_EQ(backend->range_sensor(2)->read().value(), 9.999);
  EXPECT_EQ(backend->range_sensor(2)->read_raw().value(), 256);
  EXPECT_EQ(backend->range_sensor(3), nullptr);
  EXPECT_EQ(backend->range_sensor(6), nullptr);
  EXPECT_EQ(backend->lidar(), nullptr);
  EXPECT_EQ(backend->encoder(2)->read().value(), 0);
}

TEST_F(BoardCan, DrivesInTheRobotsUnits) {
  ASSERT_TRUE(backend->drive()->set_speed({0.3, -kPi / 2}));
  robot.step();
  EXPECT_THAT(robot.last(0x20), StartsWith("201#2C01D8DC"));
  EXPECT_NEAR(backend->drive()->measured_twist().value().linear, 0.3, 1e-9);
  ASSERT_TRUE(backend->drive()->set_speed({99, 0}));
  robot.step();
  EXPECT_THAT(robot.last(0x20), StartsWith("201#58020000"));  // 0.6 m/s, the default limit
}

TEST_F(BoardCan, AGoalIsDrivingUntilTheRobotSaysDone) {
  ASSERT_TRUE(backend->drive()->start({-0.5, kPi / 2, 0.25}));
  robot.step();
  EXPECT_THAT(robot.last(0x21), StartsWith("211#03"));
  EXPECT_TRUE(robot.last(0x21).ends_with("0CFE8403FA00")) << robot.last(0x21);
  EXPECT_EQ(backend->drive()->status().value().progress, DriveProgress::Driving);
  pass(100ms);
  const DriveStatus status = backend->drive()->status().value();
  EXPECT_EQ(status.progress, DriveProgress::Driving);
  EXPECT_NEAR(status.remaining, 0.016, 1e-9);
  robot.move_state = 3;
  pass(50ms);
  EXPECT_EQ(backend->drive()->status().value().progress, DriveProgress::Done);
}

TEST_F(BoardCan, AGoalWithoutLengthIsDoneAtOnceAndStops) {
  ASSERT_TRUE(backend->drive()->start({0, 0, 0.25}));
  robot.step();
  EXPECT_EQ(robot.count(0x21), 0u);
  EXPECT_THAT(robot.last(0x20), StartsWith("201#00000000"));
  EXPECT_EQ(backend->drive()->status().value().progress, DriveProgress::Done);
}

TEST_F(BoardCan, RefusesWhatIsNotFinite) {
  const double nan = std::nan("");
  EXPECT_EQ(backend->drive()->set_speed({nan, 0}).error().code, Errc::OutOfRange);
  EXPECT_EQ(backend->drive()->start({1, nan, 1}).error().code, Errc::OutOfRange);
  EXPECT_EQ(backend->drive()->start({1, 0, -1}).error().code, Errc::OutOfRange);
  EXPECT_EQ(backend->drive()->set_odometry({nan, 0, 0}).error().code, Errc::OutOfRange);
  robot.step();
  EXPECT_EQ(robot.count(0x20) + robot.count(0x21) + robot.count(0x22), 0u);
}

TEST_F(BoardCan, OdometryGoesOnFromWhereItIsSet) {
  ASSERT_TRUE(backend->drive()->set_odometry({1.0, -2.0, kPi}));
  const Pose pose = backend->drive()->odometry().value();
  EXPECT_NEAR(pose.x, 1.0, 1e-9);
  EXPECT_NEAR(pose.y, -2.0, 1e-9);
  EXPECT_NEAR(pose.theta, kPi, 1e-9);
}

TEST_F(BoardCan, ARestartFailsTheGoalAndGivesThePoseBack) {
  ASSERT_TRUE(backend->drive()->set_odometry({1.0, 0.5, 0.0}));
  pass(500ms);
  ASSERT_TRUE(backend->drive()->start({0.5, 0, 0.25}));
  pass(100ms);
  robot.reboot();
  pass(150ms);
  EXPECT_EQ(backend->drive()->status().error().code, Errc::Disconnected);
  pass(1s);
  EXPECT_EQ(backend->drive()->status().value().progress, DriveProgress::Failed);
  EXPECT_NEAR(backend->drive()->odometry().value().x, 1.0, 1e-9);
  ASSERT_TRUE(backend->drive()->set_speed({0.1, 0}));
  EXPECT_EQ(backend->drive()->status().value().progress, DriveProgress::Done);
}

TEST_F(BoardCan, ALostRobotIsAnErrorOnEveryDevice) {
  robot.silent = true;
  pass(500ms);
  EXPECT_EQ(backend->range_sensor(1)->read().error().code, Errc::Disconnected);
  EXPECT_EQ(backend->encoder(1)->read().error().code, Errc::Disconnected);
  EXPECT_EQ(backend->motor(1)->set_duty(0.1).error().code, Errc::Disconnected);
  EXPECT_EQ(backend->servo(1)->set(0.1).error().code, Errc::Disconnected);
  EXPECT_EQ(backend->drive()->odometry().error().code, Errc::Disconnected);
  EXPECT_EQ(backend->drive()->set_speed({0.1, 0}).error().code, Errc::Disconnected);
}

TEST_F(BoardCan, StopStopsEverything) {
  ASSERT_TRUE(backend->motor(1)->set_duty(-1.0));
  ASSERT_TRUE(backend->motor(2)->set_duty(1.0));
  robot.step();
  EXPECT_THAT(robot.last(0x23), StartsWith("231#9C64000003"));
  backend->stop();
  robot.step();
  EXPECT_THAT(robot.last(0x23), StartsWith("231#000000000F"));
  EXPECT_THAT(robot.last(0x20), StartsWith("201#00000000"));
}

TEST_F(BoardCan, TheLidarGivesTheRaysThatAreAskedFor) {
  robot.send(0x2C, {7, 4, 0, 0x68, 1, 0, 0, 0});                    // 4 points, 360 degrees
  robot.send(0x2D, {0x07, 0, 0xE8, 3, 0xD0, 7, 0xB8, 0x0B});        // 1, 2, 3 m
  robot.send(0x2D, {0x17, 0, 0x0F, 0x27, 0xFF, 0xFF, 0xFF, 0xFF});  // nothing seen
  pass(20ms);
  Lidar* lidar = backend->lidar();
  ASSERT_NE(lidar, nullptr);
  EXPECT_EQ(lidar->points(), 4);
  std::array<double, 4> ranges{};
  ASSERT_TRUE(lidar->read(ranges));
  EXPECT_EQ(ranges, (std::array{1.0, 2.0, 3.0, 9.999}));
  ASSERT_TRUE(lidar->configure(2 * kPi, 0, 1));
  ASSERT_TRUE(lidar->read(std::span(ranges).first(1)));
  EXPECT_EQ(ranges[0], 3.0);  // ahead
  EXPECT_EQ(lidar->configure(2 * kPi, 0, 5).error().code, Errc::OutOfRange);
  EXPECT_EQ(lidar->configure(2 * kPi, 0.3, 4).error().code, Errc::OutOfRange);
}

TEST_F(BoardCan, AKeyOfTheRemoteControlIsReportedOnceWhileItIsHeld) {
  const auto held = [&](int key) {
    send_status(key);
    link->client().pump(clock.now() + 1ms);
  };
  held(0);
  EXPECT_EQ(backend->remote()->read().value(), 0);
  held('5');
  EXPECT_EQ(backend->remote()->read().value(), '5');
  EXPECT_EQ(backend->remote()->read().value(), 0);
  held(0);
  EXPECT_EQ(backend->remote()->read().value(), 0);
  held('5');
  EXPECT_EQ(backend->remote()->read().value(), '5');
  held('6');
  EXPECT_EQ(backend->remote()->read().value(), '6');
}

TEST_F(BoardCan, LinesAndInputsAreInItsFrames) {
  ASSERT_TRUE(backend->digital()->setup(16, LineMode::PullUp));
  ASSERT_TRUE(backend->digital()->write(9, true));
  robot.step();
  EXPECT_EQ(robot.last(0x27), "271#0F02");
  EXPECT_EQ(robot.last(0x26), "261#00010001");
  robot.send(0x1F, {0x80, 0x01, 0x00, 0x0F, 0xFF, 0x00});
  robot.send(0x28, {1, 0, 2, 0, 3, 0, 0xFF, 0xFF});
  robot.send(0x29, {5, 0, 6, 0, 7, 0, 8, 0});
  send_status(0);
  link->client().pump(clock.now() + 1ms);
  EXPECT_EQ(backend->digital()->read_all().value(), 0x0180);
  EXPECT_TRUE(backend->digital()->read(8).value());
  EXPECT_FALSE(backend->digital()->read(1).value());
  EXPECT_EQ(backend->analog()->read(2).value(), 3);
  EXPECT_EQ(backend->analog()->read(7).value(), 8);
  EXPECT_EQ(backend->analog()->read(8).value(), 0x0800);
  EXPECT_EQ(backend->analog()->read(3).error().code, Errc::Unsupported);
  EXPECT_NEAR(backend->analog()->supply_voltage().value(), 7.4, 1e-9);
  EXPECT_EQ(backend->io_board()->version().value().size(), 4u);
}

}  // namespace
}  // namespace eyebridge::hal::testing
