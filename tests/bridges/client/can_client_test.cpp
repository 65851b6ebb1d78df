// What a program asks of a robot that is well, and the bytes that it costs.
#include "can_bench.hpp"

namespace eyebridge::bridges::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using Phase = RobotWatch::Phase;

class CanClientTest : public CanBench {
 protected:
  void SetUp() override { become_ready(); }
};

using CanClientStart = CanBench;

TEST_F(CanClientStart, ListensBeforeItEnablesAndEnablesIntoSpeedZero) {
  live(390ms);
  EXPECT_EQ(robot.count(0x00), 0u);
  EXPECT_EQ(robot.state, 0);
  live(300ms);
  EXPECT_EQ(robot.last(0x00), "000#0101");
  EXPECT_THAT(robot.last(0x20), StartsWith("201#00000000"));
  EXPECT_THAT(robot.last(0x23), StartsWith("231#000000000F"));
  EXPECT_EQ(client->phase(), Phase::Ready);
}

TEST_F(CanClientStart, WaitsUntilEverythingHasCome) {
  const auto done = client->wait_ready(200ms);
  ASSERT_FALSE(done);
  EXPECT_THAT(done.error().what, HasSubstr("robot 1 on can0: heard; is being enabled"));
  EXPECT_TRUE(client->wait_ready(2s));
}

TEST_F(CanClientStart, AsksWhatTheRobotIsUntilItHasSaidSo) {
  EXPECT_TRUE(client->wait_ready(2s));
  EXPECT_EQ(client->latest<can::VersionStatus>().value().capabilities, EYECAN_CAPABLE_OF_MOVES);
  EXPECT_GE(robot.count(0x48), 1u);
  robot.clear();
  live(500ms);
  EXPECT_EQ(robot.count(0x48), 0u);
}

TEST_F(CanClientStart, WaitsForAScanOfARobotThatCanScan) {
  robot.capabilities = EYECAN_CAPABLE_OF_SCANS;
  const auto without = client->wait_ready(2s);
  ASSERT_FALSE(without);
  EXPECT_THAT(without.error().what, HasSubstr("does not send a whole scan of its LIDAR"));
  EXPECT_TRUE(client->has_lidar());
  robot.send(0x2C, {7, 1, 0, 0x68, 1, 0, 0, 0});
  robot.send(0x2D, {0x07, 0, 1, 1, 0xFF, 0xFF, 0xFF, 0xFF});
  EXPECT_TRUE(client->wait_ready(100ms));
}

TEST_F(CanClientStart, WaitsForAReadingOfEachRangeMatrixThatTheRobotTellsOf) {
  robot.capabilities = 4 * EYECAN_CAPABLE_OF_ZONES;
  const auto without = client->wait_ready(2s);
  ASSERT_FALSE(without);
  EXPECT_THAT(without.error().what, HasSubstr("does not send a whole reading of range matrix 3"));
  EXPECT_TRUE(client->has_range_matrix(3));
  EXPECT_FALSE(client->has_range_matrix(1));
  for (std::uint8_t chunk = 0; chunk < 22; ++chunk) {
    robot.send(0x2E, {0x53, chunk, 1, 1, 2, 2, 3, 3});
  }
  EXPECT_TRUE(client->wait_ready(100ms));
}

TEST_F(CanClientStart, SaysThatNobodyIsThere) {
  robot.silent = true;
  live(1s);
  EXPECT_EQ(client->wait_ready(10ms).error().what,
            "robot 1 on can0: not heard yet; expected its heartbeat");
  EXPECT_EQ(client->drive(100, 0).error().code, Errc::Disconnected);
}

TEST_F(CanClientTest, KeepsTheHostsHeartbeat) {
  robot.clear();
  live(1s);
  EXPECT_GE(robot.count(0x70), 9u);
  EXPECT_LE(robot.count(0x70), 11u);
  EXPECT_EQ(robot.last(0x70), "70F#05");
}

TEST_F(CanClientTest, GivesTheLatestOfEachStatus) {
  EXPECT_EQ(client->latest<can::PsdAStatus>().value().range_mm[0], 500);
  EXPECT_EQ(client->latest<can::PsdAStatus>().value().range_mm[1], EYECAN_PSD_OUT_OF_RANGE);
  EXPECT_EQ(client->latest<can::Encoder12Status>().value().ticks[1], 2);
  EXPECT_EQ(client->latest<can::SpeedStatus>().value().v_mm_s, 300);
  EXPECT_EQ(client->latest<can::BoardStatus>().value().battery_cv, 740);
  robot.psd_mm = 321;
  live(60ms);
  EXPECT_EQ(client->latest<can::PsdAStatus>().value().range_mm[0], 321);
}

TEST_F(CanClientTest, RepeatsASpeedForAsLongAsTheProgramLives) {
  robot.clear();
  ASSERT_TRUE(client->drive(300, -9000));
  robot.step();
  EXPECT_THAT(robot.last(0x20), StartsWith("201#2C01D8DC"));
  robot.clear();
  live(1s);
  EXPECT_GE(robot.count(0x20), 19u);
  EXPECT_LE(robot.count(0x20), 21u);
  EXPECT_THAT(robot.last(0x20), StartsWith("201#2C01D8DC"));
}

TEST_F(CanClientTest, RepeatsAMoveOnlyUntilItIsEchoed) {
  robot.obeys = false;
  robot.clear();
  ASSERT_TRUE(client->move({.type = 1, .distance_mm = 500, .speed = 250}));
  live(200ms);
  EXPECT_GE(robot.count(0x21), 3u);
  EXPECT_EQ(client->move_progress().value(), MoveProgress::Sent);
  robot.obeys = true;
  live(100ms);
  robot.clear();
  live(500ms);
  EXPECT_EQ(robot.count(0x21), 0u);
  EXPECT_EQ(robot.count(0x20), 0u);
  EXPECT_EQ(client->move_progress().value(), MoveProgress::Running);
  robot.move_state = 3;
  live(40ms);
  EXPECT_EQ(client->move_progress().value(), MoveProgress::Done);
  robot.move_state = 4;
  live(40ms);
  EXPECT_EQ(client->move_progress().value(), MoveProgress::Failed);
}

TEST_F(CanClientTest, AMoveThatIsNeverEchoedHasFailed) {
  robot.obeys = false;
  ASSERT_TRUE(client->move({.type = 2, .angle_ddeg = 900, .speed = 60}));
  live(1s);
  EXPECT_EQ(client->move_progress().value(), MoveProgress::Failed);
  EXPECT_GE(client->statistics().move_repeats, 5u);
}

TEST_F(CanClientTest, MotorsAreToldTogetherEachInItsMode) {
  ASSERT_TRUE(client->motor(1, -100, EYECAN_MOTOR_PERCENT));
  ASSERT_TRUE(client->motor(2, 100, EYECAN_MOTOR_PERCENT));
  robot.step();
  EXPECT_THAT(robot.last(0x23), StartsWith("231#9C64000003"));
  ASSERT_TRUE(client->motor(3, -128, EYECAN_MOTOR_TICKS));
  robot.step();
  EXPECT_THAT(robot.last(0x23), StartsWith("231#0000800014"));
  robot.clear();
  live(500ms);
  EXPECT_GE(robot.count(0x23), 18u);  // both modes, every 50 ms
  EXPECT_EQ(client->motor(5, 0, 0).error().code, Errc::OutOfRange);
}

TEST_F(CanClientTest, ServosKeepTheirBankTogether) {
  ASSERT_TRUE(client->servo(8, 10));
  ASSERT_TRUE(client->servo(14, 70));
  robot.step();
  EXPECT_EQ(robot.last(0x25), "251#010A808080808046");
  EXPECT_EQ(client->servo(15, 0).error().code, Errc::OutOfRange);
}

TEST_F(CanClientTest, APoseIsTakenBeforeTheCallReturns) {
  ASSERT_TRUE(client->set_pose({100, 0, 0}));
  EXPECT_EQ(client->latest<can::PoseStatus>().value(), (can::PoseStatus{100, 0, 0}));
  ASSERT_TRUE(client->set_pose({1000, -2000, 18000}));
  EXPECT_EQ(client->latest<can::PoseStatus>().value(), (can::PoseStatus{1000, -2000, 18000}));
  EXPECT_EQ(robot.last(0x22), "221#E8030030F8FF5046");
}

TEST_F(CanClientTest, AJumpOfThePoseIsBelievedAtOnce) {
  const Time start = clock.now();
  ASSERT_TRUE(client->set_pose({1000, -2000, 18000}));
  EXPECT_LE(clock.now() - start, 25ms) << "a robot tells its pose every 20 ms";
  EXPECT_EQ(client->latest<can::PoseStatus>().value(), (can::PoseStatus{1000, -2000, 18000}));
}

TEST_F(CanClientTest, APoseNearTheOldOneIsNotBelievedUntilItMustBeNew) {
  ASSERT_TRUE(client->set_pose({10, 0, 0}));
  EXPECT_EQ(client->latest<can::PoseStatus>().value(), (can::PoseStatus{10, 0, 0}));
}

TEST_F(CanClientTest, APoseThatIsNotTakenIsAnError) {
  robot.obeys = false;
  EXPECT_EQ(client->set_pose({1000, -2000, 18000}).error().code, Errc::Timeout);
  EXPECT_EQ(client->set_pose({1 << 23, 0, 0}).error().code, Errc::OutOfRange);
}

TEST_F(CanClientTest, StopsWhateverItWasDoing) {
  ASSERT_TRUE(client->drive(300, 0));
  client->stop();
  robot.clear();
  live(200ms);
  EXPECT_GE(robot.count(0x23), 3u);
  EXPECT_THAT(robot.last(0x20), StartsWith("201#00000000"));
  EXPECT_THAT(robot.last(0x23), StartsWith("231#000000000F"));
}

TEST_F(CanClientTest, TheLastWordOfAStopIsAboutTheMotors) {
  ASSERT_TRUE(client->drive(300, 0));
  client->stop();
  robot.step();
  // A speed after it would be reached by a ramp, from the one that the robot had.
  EXPECT_EQ(robot.heard.back().id, 0x231u);
}

TEST_F(CanClientTest, ItsEndLeavesTheRobotAtZeroAndInStandby) {
  ASSERT_TRUE(client->drive(300, 0));
  robot.step();
  robot.clear();
  client.reset();
  robot.step();
  EXPECT_THAT(robot.last(0x20), StartsWith("201#00000000"));
  EXPECT_THAT(robot.last(0x23), StartsWith("231#000000000F"));
  EXPECT_EQ(robot.last(0x00), "000#8001");
}

TEST_F(CanClientTest, PutsTheChunksOfAScanTogether) {
  EXPECT_FALSE(client->has_lidar());
  robot.send(0x2C, {7, 4, 0, 0x68, 1, 0, 0, 0});
  robot.send(0x2D, {0x17, 0, 4, 4, 0xFF, 0xFF, 0xFF, 0xFF});
  robot.send(0x2D, {0x07, 0, 1, 1, 2, 2, 3, 3});
  live(20ms);
  EXPECT_TRUE(client->has_lidar());
  const auto scan = std::make_unique<can::LidarScan>();
  ASSERT_TRUE(client->latest_scan(*scan));
  ASSERT_EQ(scan->points().size(), 4u);
  EXPECT_EQ(scan->points()[2], 0x0303);
  EXPECT_EQ(scan->points()[3], 0x0404);
  live(1100ms);
  EXPECT_EQ(client->latest_scan(*scan).error().code, Errc::Timeout);
}

TEST_F(CanClientTest, PutsTheZonesOfARangeMatrixTogether) {
  EXPECT_FALSE(client->has_range_matrix(2));
  EXPECT_FALSE(client->has_range_matrix(0));
  EXPECT_FALSE(client->has_range_matrix(9));
  EXPECT_EQ(client->latest_zones(2).error().code, Errc::Timeout);
  EXPECT_EQ(client->latest_zones(9).error().code, Errc::NoDevice);
  for (std::uint8_t chunk = 0; chunk < 22; ++chunk) {
    robot.send(0x2E, {0x52, chunk, chunk, 0, 2, 2, 3, 3});
  }
  live(20ms);
  EXPECT_TRUE(client->has_range_matrix(2));
  const can::Zones zones = client->latest_zones(2).value();
  EXPECT_EQ(zones[0], 0);
  EXPECT_EQ(zones[61], 0x0202);
  EXPECT_EQ(zones[63], 21);
  live(1100ms);
  EXPECT_EQ(client->latest_zones(2).error().code, Errc::Timeout);
}

TEST_F(CanClientTest, FramesOfAnOldReadingAreNotMixedWithOnesOfTheSameNumber) {
  for (std::uint8_t chunk = 1; chunk < 22; ++chunk) {
    robot.send(0x2E, {0x51, chunk, 1, 1, 2, 2, 3, 3});
  }
  live(300ms);
  robot.send(0x2E, {0x51, 0, 1, 1, 2, 2, 3, 3});
  live(20ms);
  EXPECT_FALSE(client->has_range_matrix(1));
}

TEST_F(CanClientTest, FramesThatAreTooShortAreCountedAndReported) {
  robot.send(0x1C, {1, 0, 2, 0});
  robot.send(0x1C, {1, 0, 2, 0});
  live(10ms);
  EXPECT_EQ(client->statistics().corrupt, 2u);
  EXPECT_THAT(log.text(), HasSubstr("can0: ignored a frame: S_PsdA 0x1C1 has 4 bytes; expected 8"));
  EXPECT_EQ(client->latest<can::PsdAStatus>().value().range_mm[0], 500);
}

TEST_F(CanClientTest, FramesOfOthersOnTheBusAreIgnored) {
  const auto other = bus.connect("other");
  ASSERT_TRUE(other->send(raw_frame(0x1C2, {9, 9, 9, 9, 9, 9, 9, 9}), Time{0}));
  ASSERT_TRUE(other->send(raw_frame(0x333, {1, 2, 3}), Time{0}));
  live(10ms);
  EXPECT_EQ(client->latest<can::PsdAStatus>().value().range_mm[0], 500);
  EXPECT_EQ(client->statistics().corrupt, 0u);
}

}  // namespace
}  // namespace eyebridge::bridges::testing
