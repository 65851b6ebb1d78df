#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "board_fixture.hpp"
#include "opcodes.h"

namespace eyebridge::firmware {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::StartsWith;

eb_config node_one() {
  return config_with([](eb_config& config) { config.node = 1; });
}

class CanNode : public testing::Test {
 protected:
  /// What S_Fault frames said since the last call: the code's four hex digits as on the wire.
  std::vector<std::string> faults() {
    std::vector<std::string> codes;
    for (const std::string& frame : host.frames()) {
      if (frame.starts_with("081#")) codes.push_back(frame.substr(4, 4));
    }
    return codes;
  }
  int duty() const { return host.board.pins.duty[0]; }
  /// `ms` with the host's heartbeat every 100 ms.
  void wait_alive(std::uint32_t ms) {
    for (; ms > 0; ms -= std::min(ms, 100U)) {
      host.send("70F#05");
      host.wait_ms(std::min(ms, 100U), [this] { plant.step(host.board); });
    }
  }

  static constexpr const char* kHalfDuty = "231#3200000001000000";
  static constexpr const char* kForward = "201#C80000000100";  // 200 mm/s

  BoardUnderTest host{node_one()};
  Plant plant;
};

TEST_F(CanNode, BootsAndWaitsInStandby) {
  EXPECT_THAT(host.frames(), ElementsAre("701#00", StartsWith("481#01312E3034"), "701#7F"));
  host.send(kHalfDuty);
  host.wait_ms(20);
  EXPECT_EQ(duty(), 0) << "nothing moves before it is enabled";
}

TEST_F(CanNode, IsEnabledByItsNumberOrByAll) {
  host.frames();
  host.send("000#0102");
  EXPECT_EQ(host.board.node.state, EYECAN_STATE_STANDBY) << "that was for node 2";
  host.send("000#0101");
  EXPECT_EQ(host.board.node.state, EYECAN_STATE_OPERATIONAL);
  EXPECT_THAT(host.frames(), ElementsAre("701#05"));
  host.send("000#8000");
  EXPECT_EQ(host.board.node.state, EYECAN_STATE_STANDBY);
  host.send("000#0100");
  EXPECT_EQ(host.board.node.state, EYECAN_STATE_OPERATIONAL);
  host.send(kHalfDuty);
  EXPECT_EQ(duty(), 5000);
  host.send("000#0201");
  EXPECT_EQ(host.board.node.state, EYECAN_STATE_STOPPED);
  EXPECT_EQ(duty(), 0);
}

TEST_F(CanNode, SendsEachStatusAtItsPeriod) {
  host.enable();
  std::map<std::string, int> count;
  for (int i = 0; i < 1000; ++i) {
    if (i % 10 == 0) host.send("70F#05");
    host.wait_ms(10);
    for (const std::string& frame : host.frames()) ++count[frame.substr(0, 3)];
  }
  EXPECT_EQ(count, (std::map<std::string, int>{{"181", 500},
                                               {"191", 500},
                                               {"1A1", 500},
                                               {"1B1", 100},
                                               {"1C1", 200},
                                               {"1D1", 200},
                                               {"1E1", 200},
                                               {"1F1", 200},
                                               {"281", 100},
                                               {"291", 100},
                                               {"2A1", 100},
                                               {"481", 2},
                                               {"701", 100}}));
}

TEST_F(CanNode, SpeedMustBeRepeatedEvery250Milliseconds) {
  host.enable();
  host.send(kForward);
  host.wait_us(249'999);
  EXPECT_FALSE(host.board.node.timed_out);
  EXPECT_GT(duty(), 0);
  host.wait_us(1);
  EXPECT_TRUE(host.board.node.timed_out);
  EXPECT_THAT(faults(), ElementsAre("02FF"));
  wait_alive(1000);
  EXPECT_EQ(duty(), 0) << "down the ramp";
  host.send(kForward);
  wait_alive(100);
  EXPECT_GT(duty(), 0);
  EXPECT_THAT(faults(), Contains("0000")) << "it is over";
}

TEST_F(CanNode, RawMotorsMustBeRepeatedEvery250Milliseconds) {
  host.enable();
  host.send(kHalfDuty);
  host.wait_us(249'999);
  EXPECT_EQ(duty(), 5000);
  host.wait_us(1);
  EXPECT_EQ(duty(), 0);
}

TEST_F(CanNode, AMoveNeedsNoRepetition) {
  host.enable();
  host.send("211#0107E803000064 00");  // 1 m at 100 mm/s
  wait_alive(2000);
  EXPECT_GT(duty(), 0);
  EXPECT_EQ(host.board.drive.move_state, EYECAN_MOVE_RUNNING);
  EXPECT_FALSE(host.board.node.timed_out);
}

TEST_F(CanNode, WithoutTheHostsHeartbeatItStandsBy) {
  host.enable();
  host.send("211#0107E80300006400");
  host.wait_us(299'999);
  EXPECT_GT(duty(), 0);
  host.wait_us(1);
  EXPECT_EQ(duty(), 0);
  EXPECT_EQ(host.board.node.state, EYECAN_STATE_STANDBY);
  EXPECT_THAT(faults(), ElementsAre("3081"));
  wait_alive(500);
  EXPECT_EQ(host.board.node.state, EYECAN_STATE_STANDBY) << "a heartbeat alone is not enough";
  host.send("000#0101");
  wait_alive(500);
  EXPECT_EQ(duty(), 0) << "the old command does not go on";
  host.send("211#0107E80300006400");
  wait_alive(100);
  EXPECT_GT(duty(), 0) << "a new one does, whatever its number";
}

TEST_F(CanNode, EmergencyStopIsLatched) {
  host.enable();
  host.send(kHalfDuty);
  host.send("010#0100");
  EXPECT_EQ(duty(), 0);
  EXPECT_EQ(host.board.node.state, EYECAN_STATE_STOPPED);
  host.wait_us(499'999);
  host.send("000#0101");
  EXPECT_EQ(host.board.node.state, EYECAN_STATE_STOPPED) << "too early";
  EXPECT_THAT(faults(), ElementsAre("01FF"));
  host.wait_us(1);
  host.send("000#0101");
  EXPECT_EQ(host.board.node.state, EYECAN_STATE_OPERATIONAL);
  EXPECT_EQ(duty(), 0);
  wait_alive(30);
  EXPECT_THAT(faults(), ElementsAre("0000"));
}

TEST_F(CanNode, FaultsAreRepeatedEverySecondWhileTheyLast) {
  host.frames();
  host.board.pins.supply_cv = 500;
  std::vector<std::string> codes;
  for (int i = 0; i < 350; ++i) {
    host.wait_ms(10);
    for (const std::string& code : faults()) codes.push_back(code);
  }
  EXPECT_THAT(codes, ElementsAre("2031", "2031", "2031", "2031"));
}

TEST_F(CanNode, AMoveIsExecutedOnceHoweverOftenItIsSent) {
  host.enable();
  const auto go = [&] { plant.step(host.board); };
  for (int i = 0; i < 30; ++i) {
    host.send("211#0109C800000064 00");  // 200 mm at 100 mm/s
    host.send("70F#05");
    host.wait_ms(100, go);
  }
  EXPECT_EQ(host.board.drive.move_state, EYECAN_MOVE_DONE);
  EXPECT_NEAR(eb_drive_x_mm(&host.board.drive), 200, 1);
  host.send("211#010AC80000006400");
  for (int i = 0; i < 30; ++i) {
    host.send("70F#05");
    host.wait_ms(100, go);
  }
  EXPECT_NEAR(eb_drive_x_mm(&host.board.drive), 400, 1);
}

TEST_F(CanNode, TwoNodesWithOneNumberStandStillAndSaySo) {
  BoardUnderTest other(node_one());
  other.enable();
  host.enable();
  host.send(kHalfDuty);
  for (const std::string& frame : other.frames()) host.send(frame);
  other.wait_ms(100);
  for (const std::string& frame : other.frames()) host.send(frame);
  EXPECT_EQ(duty(), 0);
  EXPECT_EQ(host.board.node.state, EYECAN_STATE_STANDBY);
  host.wait_ms(20);
  EXPECT_THAT(faults(), ElementsAre("5081"));
  host.send("000#0101");
  EXPECT_EQ(host.board.node.state, EYECAN_STATE_STANDBY) << "not while the other one is there";
  wait_alive(1000);
  host.send("000#0101");
  EXPECT_EQ(host.board.node.state, EYECAN_STATE_OPERATIONAL);
}

TEST_F(CanNode, BadFramesAreReportedAndHaveNoEffect) {
  host.enable();
  host.send("201#C800000001");
  host.wait_ms(20);
  EXPECT_THAT(host.frames(), Contains("081#1082110000010205"));
  host.send("231#6500000001000000");
  host.wait_ms(20);
  EXPECT_THAT(host.frames(), Contains("081#2082110000310200"));
  host.wait_ms(20);
  EXPECT_THAT(faults(), ElementsAre("0000"));
  EXPECT_EQ(duty(), 0);
}

TEST_F(CanNode, ServosPortsAndGainsAreSet) {
  host.enable();
  host.send("251#01FF000000000000");
  EXPECT_EQ(host.board.pins.servo_us[7], 2000);
  host.send("271#0001");
  host.send("261#01000100");
  EXPECT_EQ(host.board.pins.digital_outputs & 1, 1);
  EXPECT_EQ(host.board.pins.digital_out, 1);
  host.wait_ms(1);
  EXPECT_THAT(host.frames(), Contains("1F1#FF00010001FF")) << "sent on change";
  host.send("241#020A141E");
  EXPECT_EQ(host.board.motors.motor[1].d, 30);
  host.send("221#E8030030F8FF2823");
  EXPECT_EQ(eb_drive_x_mm(&host.board.drive), 1000);
  EXPECT_EQ(eb_drive_y_mm(&host.board.drive), -2000);
  EXPECT_EQ(eb_drive_heading_cdeg(&host.board.drive), 9000);
}

TEST_F(CanNode, ResetIsARestart) {
  host.enable();
  host.wait_ms(250);
  host.send(kHalfDuty);
  host.send("000#8101");
  EXPECT_EQ(duty(), 0);
  EXPECT_EQ(host.board.uptime_us, 0U);
  EXPECT_THAT(host.frames(), ElementsAre("701#00", StartsWith("481#"), "701#7F"));
}

TEST_F(CanNode, SaysWhatItCan) {
  EXPECT_THAT(host.frames(), Contains("481#01312E3034010100")) << "moves";
  host.board.config.lidar = true;
  host.send("481#R");
  EXPECT_THAT(host.frames(), ElementsAre("481#01312E3034010300")) << "and scans";
}

TEST_F(CanNode, ASensorThatIsNotConnectedIsAbsent) {
  static const std::uint16_t table[EB_PSD_TABLE] = {};
  host.board.config.psd_mm = table;
  host.board.pins.psd[1] = EB_PSD_ABSENT;
  host.enable();
  host.wait_ms(50);
  const auto frames = host.frames();
  EXPECT_THAT(frames, Contains("1C1#0000FFFF00000000"));
  EXPECT_THAT(frames, Contains("1E1#0000FFFF00000000"));
}

TEST_F(CanNode, AHeldWheelStaysHeldWhenTheSpeedIsRepeated) {
  plant.held = true;
  host.enable();
  for (int i = 0; i < 20; ++i) {
    host.send(kForward);
    host.wait_ms(50, [this] { plant.step(host.board); });
    host.send("70F#05");
  }
  EXPECT_TRUE(host.board.drive.stalled[0]);
  host.send("201#38FF00000200");  // -200 mm/s
  EXPECT_FALSE(host.board.drive.stalled[0]) << "another speed is another try";
}

TEST_F(CanNode, ARobotThatWasJustStoppedIsNotStartedAgainByASpeedOfZero) {
  host.enable();
  host.send(kHalfDuty);
  wait_alive(100);
  host.send("231#0000000001000000");
  host.wait_ms(20, [this] { plant.step(host.board); });
  const std::uint16_t stood = host.board.pins.encoder[0];
  host.send("201#000000000100");
  wait_alive(100);
  EXPECT_EQ(host.board.pins.encoder[0], stood);
}

TEST_F(CanNode, APoseThatIsSetIsToldAtOnce) {
  host.enable();
  host.frames();
  host.send("221#E8030030F8FF5046");
  EXPECT_THAT(host.frames(), ElementsAre("181#E8030030F8FFB0B9"));
}

TEST_F(CanNode, TheVersionIsSentOnRequest) {
  host.frames();
  host.send("481#R");
  EXPECT_THAT(host.frames(), ElementsAre(StartsWith("481#01")));
}

TEST_F(CanNode, ALostBusStopsAtOnceAndIsReportedLater) {
  host.enable();
  host.send(kHalfDuty);
  eb_board_can_lost(&host.board);
  EXPECT_EQ(duty(), 0);
  host.wait_ms(20);
  EXPECT_THAT(faults(), ElementsAre("4081"));
}

TEST_F(CanNode, AScanGoesOutInChunks) {
  host.frames();
  eb_scan scan{
      .points = 7, .range_deg = 180, .tilt_deg = -5, .range_mm = {1, 2, 3, 4, 5, 6, 12000}};
  ASSERT_TRUE(eb_board_lidar(&host.board, &scan));
  EXPECT_FALSE(eb_board_lidar(&host.board, &scan)) << "one at a time";
  EXPECT_THAT(host.frames(), ElementsAre("2C1#010700B400FB0000", "2D1#0100010002000300",
                                         "2D1#1100040005000600", "2D1#21000F27FFFFFFFF"));
  EXPECT_TRUE(eb_board_lidar(&host.board, &scan));
}

TEST_F(CanNode, AScanGoesOutInLongFramesOnAnFdBus) {
  BoardUnderTest fd(config_with([](eb_config& config) {
    config.node = 1;
    config.can_fd = true;
  }));
  fd.frames();
  eb_scan scan{.points = 31, .range_deg = 360, .tilt_deg = 0, .range_mm = {}};
  ASSERT_TRUE(eb_board_lidar(&fd.board, &scan));
  EXPECT_THAT(fd.frames(), ElementsAre("2C1#011F006801000000", StartsWith("2D1##1011E0000"),
                                       StartsWith("2D1##101011E00")));
}

TEST_F(CanNode, AReadingOfARangeMatrixGoesOutInTwentyTwoFrames) {
  host.frames();
  std::array<std::uint16_t, EB_ZONES> zones{};
  std::iota(zones.begin(), zones.end(), std::uint16_t{1});
  zones.back() = 12000;
  ASSERT_TRUE(eb_board_zones(&host.board, 2, zones.data()));
  EXPECT_FALSE(eb_board_zones(&host.board, 1, zones.data())) << "one at a time";
  const std::vector<std::string> frames = host.frames();
  ASSERT_EQ(frames.size(), 22U);
  EXPECT_EQ(frames.front(), "2E1#1200010002000300");
  EXPECT_EQ(frames[20], "2E1#12143D003E003F00");
  EXPECT_EQ(frames.back(), "2E1#12150F27FFFFFFFF");
  EXPECT_TRUE(eb_board_zones(&host.board, 1, zones.data()));
  EXPECT_EQ(host.frames().front(), "2E1#2100010002000300");
  EXPECT_FALSE(eb_board_zones(&host.board, 0, zones.data()));
  EXPECT_FALSE(eb_board_zones(&host.board, 9, zones.data()));
}

TEST_F(CanNode, DistancesComeFromTheTable) {
  std::vector<std::uint16_t> table(EB_PSD_TABLE, 9999);
  table[1000] = 345;
  BoardUnderTest robot(config_with([&](eb_config& config) {
    config.node = 1;
    config.psd_mm = table.data();
  }));
  robot.board.pins.psd[1] = 1000;
  robot.wait_ms(50);
  EXPECT_THAT(robot.frames(), Contains("1C1#0F2759010F270F27"));
  host.wait_ms(50);
  EXPECT_THAT(host.frames(), Contains("1C1#FFFFFFFFFFFFFFFF")) << "no table, no distance";
}

}  // namespace
}  // namespace eyebridge::firmware
