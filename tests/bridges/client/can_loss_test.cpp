// Robots that go away, restart, are stopped or are two; buses that fail; noise.
#include <random>

#include "can_bench.hpp"
#include "noise_amount.hpp"

namespace eyebridge::bridges::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using Phase = RobotWatch::Phase;

class CanLoss : public CanBench {
 protected:
  void SetUp() override {
    become_ready();
    ASSERT_TRUE(client->drive(300, 0));
    live(100ms);
  }
  /// Nothing that was sent since clear() makes the robot drive.
  void expect_only_zero() {
    for (const CanFrame& frame : robot.heard) {
      const std::string text = text_of(frame);
      if (text.starts_with("201#")) {
        EXPECT_THAT(text, StartsWith("201#00000000"));
      }
      if (text.starts_with("231#")) {
        EXPECT_THAT(text, StartsWith("231#00000000"));
      }
      EXPECT_FALSE(text.starts_with("211#")) << text;
    }
  }
};

TEST_F(CanLoss, ASilentRobotIsAnErrorAfter300MsAndNoOldReading) {
  robot.silent = true;
  live(250ms);
  EXPECT_EQ(client->phase(), Phase::Ready);
  live(200ms);
  EXPECT_EQ(client->phase(), Phase::Lost);
  EXPECT_EQ(client->latest<can::PsdAStatus>().error().what,
            "robot 1 on can0: lost: no heartbeat for 300 ms");
  EXPECT_EQ(client->drive(300, 0).error().code, Errc::Disconnected);
  EXPECT_EQ(client->generation(), 1u);
}

TEST_F(CanLoss, ARobotThatIsBackStandsUntilItIsToldAgain) {
  robot.silent = true;
  live(500ms);
  robot.silent = false;
  robot.clear();
  live(500ms);
  EXPECT_EQ(client->phase(), Phase::Ready);
  EXPECT_GE(robot.count(0x00), 1u);
  expect_only_zero();
  EXPECT_TRUE(client->drive(100, 0));
}

TEST_F(CanLoss, AStatusThatStopsComingIsATimeout) {
  robot.silent = true;
  for (int i = 0; i < 50; ++i) {
    live(10ms);
    const int state = robot.state;
    robot.silent = false;
    robot.send(0x70, {state});
    robot.silent = true;
  }
  EXPECT_EQ(client->phase(), Phase::Ready);
  EXPECT_EQ(client->latest<can::PsdAStatus>().error().what, "can0: robot 1 sends no S_PsdA");
}

TEST_F(CanLoss, ARestartIsSeenByItsBootHeartbeatAndParametersAreSentAgain) {
  ASSERT_TRUE(client->pid({.motor = 2, .p = 10, .i = 20, .d = 30}));
  ASSERT_TRUE(client->servo(1, 77));
  live(100ms);
  robot.reboot();
  live(110ms);
  robot.clear();
  live(400ms);
  EXPECT_EQ(client->phase(), Phase::Ready);
  EXPECT_EQ(robot.last(0x24), "241#020A141E");
  EXPECT_THAT(robot.last(0x25), StartsWith("251#004D80"));
  expect_only_zero();
  EXPECT_THAT(log.text(), HasSubstr("robot 1 on can0: has restarted; is being enabled again"));
}

TEST_F(CanLoss, ARestartBetweenTwoHeartbeatsIsSeenByTheUptime) {
  robot.started = clock.now();
  robot.clear();
  live(200ms);
  EXPECT_EQ(client->generation(), 1u);
  live(300ms);
  EXPECT_EQ(client->phase(), Phase::Ready);
  EXPECT_GE(robot.count(0x00), 1u);
}

TEST_F(CanLoss, AMoveOfARobotThatRestartedHasFailed) {
  ASSERT_TRUE(client->move({.type = 1, .distance_mm = 500, .speed = 250}));
  live(100ms);
  const std::uint32_t generation = client->generation();
  robot.reboot();
  live(110ms);
  EXPECT_EQ(client->move_progress().error().code, Errc::Disconnected);
  robot.clear();
  live(500ms);
  EXPECT_GT(client->generation(), generation);
  expect_only_zero();
}

TEST_F(CanLoss, AnEmergencyStopIsRepeatedAndNothingElseMoves) {
  robot.clear();
  client->emergency_stop(EYECAN_ESTOP_USER);
  robot.step();
  EXPECT_THAT(robot.last(0x01), StartsWith("011#01"));
  EXPECT_EQ(client->drive(300, 0).error().code, Errc::Disconnected);
  live(1s);
  EXPECT_GE(robot.count(0x01), 9u);
  EXPECT_EQ(robot.count(0x00), 0u);
  client->release();
  robot.clear();
  live(500ms);
  EXPECT_EQ(robot.count(0x01), 0u);
  EXPECT_EQ(robot.count(0x00), 0u);
  live(500ms);
  EXPECT_EQ(client->phase(), Phase::Ready);
  expect_only_zero();
}

TEST_F(CanLoss, AnEmergencyStopByAnotherIsNotUndone) {
  robot.send(0x08, {0x01, 0xFF, 1, 0, 0, 0, 0, 0});
  robot.state = 4;
  robot.clear();
  live(2s);
  EXPECT_EQ(client->phase(), Phase::EmergencyStopped);
  EXPECT_EQ(robot.count(0x00), 0u);
  EXPECT_THAT(client->drive(1, 0).error().what, HasSubstr("emergency stop; expected that it is"));
}

TEST_F(CanLoss, TwoRobotsWithOneNumberAreFoundOutAndNeitherIsDriven) {
  FakeRobot twin(bus.connect("twin"), 1, clock);
  twin.started = clock.now() - 5s;
  twin.state = 5;
  clock.live = [&] {
    robot.step();
    twin.step();
  };
  live(1s);
  EXPECT_EQ(client->phase(), Phase::Twice);
  EXPECT_EQ(client->drive(300, 0).error().code, Errc::Corrupt);
  EXPECT_THAT(log.text(), HasSubstr("two robots have this number"));
  robot.clear();
  live(1s);
  expect_only_zero();
  EXPECT_EQ(robot.count(0x00), 0u);
  clock.live = {};
}

TEST_F(CanLoss, TwoRobotsThatWereSwitchedOnTogetherAreFoundOutToo) {
  FakeRobot twin(bus.connect("twin"), 1, clock);
  twin.state = 5;
  clock.live = [&] {
    robot.step();
    twin.step();
  };
  live(5s);
  EXPECT_EQ(client->phase(), Phase::Twice);
  clock.live = {};
}

TEST_F(CanLoss, ARobotThatHearsItsTwinIsBelieved) {
  robot.send(0x08, {0x50, 0x81, 0x10, 0, 0, 0, 0, 0});
  live(10ms);
  EXPECT_EQ(client->phase(), Phase::Twice);
}

TEST_F(CanLoss, FaultsAreReportedInWords) {
  robot.send(0x08, {0x20, 0x31, 5, 0, 0, 0, 0, 0});
  live(10ms);
  EXPECT_THAT(log.text(), HasSubstr("can0: robot 1 reports: its battery is low"));
}

TEST_F(CanLoss, ABusThatIsOffSaysSo) {
  CanFrame report;
  report.id = 0x40;  // CAN_ERR_BUSOFF
  report.length = 8;
  bus.report(report);
  live(100ms);
  EXPECT_EQ(client->phase(), Phase::Lost);
  EXPECT_THAT(client->drive(1, 0).error().what, HasSubstr("can0: bus off"));
  EXPECT_EQ(client->statistics().bus.bus_off, 1u);
}

TEST_F(CanLoss, RobotsThatLeaveTheBusAreNamed) {
  clock.live = {};
  robot.bus.reset();
  live(100ms);
  EXPECT_THAT(client->latest<can::PoseStatus>().error().what,
              HasSubstr("all other nodes are gone"));
}

TEST_F(CanLoss, RandomFramesNeitherCrashNorMoveAnything) {
  client->stop();
  live(50ms);
  robot.clear();
  clock.live = {};
  std::mt19937_64 next(1);
  const std::uint64_t frames = eyebridge::testing::noise_amount(50'000);
  for (std::uint64_t i = 0; i < frames; ++i) {
    CanFrame frame;
    frame.id = static_cast<std::uint32_t>(next() >> 20U) & 0x7FFU;
    if (next() % 2 == 0) frame.id = (frame.id & 0x7F0U) | 1U;
    frame.length = static_cast<std::uint8_t>(next() % 9);
    for (std::uint8_t& byte : frame.data) byte = static_cast<std::uint8_t>(next() >> 32U);
    ASSERT_TRUE(robot.bus->send(frame, Time{0}));
    if (i % 100 == 0) {
      client->pump(clock.now() + 1ms);
      while (robot.bus->receive(Time{0})) {
      }
    }
  }
  EXPECT_GT(client->statistics().corrupt, frames / 100);
  clock.live = [this] { robot.step(); };
  live(500ms);
  expect_only_zero();
}

}  // namespace
}  // namespace eyebridge::bridges::testing
