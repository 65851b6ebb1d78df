// What part 2 of SPECIFICATION.md says beside its tables, sentence by sentence, of the firmware.
#include <algorithm>

#include <gmock/gmock.h>

#include "board_fixture.hpp"
#include "opcodes.h"

namespace eyebridge::firmware {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::StartsWith;

class CanRules : public testing::Test {
 protected:
  CanRules() {
    plant.lag = 0.02;
    host.enable();
  }
  /// With the host's heartbeat; drops what the board says.
  void wait(std::uint32_t ms) {
    for (; ms > 0; ms -= std::min(ms, 100U)) {
      host.send("70F#05");
      host.wait_ms(std::min(ms, 100U), [this] { plant.step(host.board); });
    }
    host.frames();
  }
  /// The next frame with this identifier, in hexadecimal digits; waits for it.
  std::string next(const std::string& id) {
    for (int i = 0; i < 20; ++i) {
      for (const std::string& frame : host.frames()) {
        if (frame.starts_with(id + "#")) return frame.substr(4);
      }
      host.send("70F#05");
      host.wait_ms(10, [this] { plant.step(host.board); });
    }
    return "none";
  }
  std::string speed_frame() { return next("191"); }
  int move_state() { return speed_frame()[9] - '0'; }
  int state() const { return host.board.node.state; }
  bool has_power() const {
    return std::any_of(host.board.pins.duty, host.board.pins.duty + 4,
                       [](int duty) { return duty != 0; });
  }

  static constexpr const char* kMove = "211#0107E80300006400";  // 1 m at 100 mm/s, Seq 7
  static constexpr const char* kSpeed = "201#C80000000100";     // 200 mm/s
  static constexpr const char* kMotors = "231#3232000003000000";

  BoardUnderTest host{config_with([](eb_config& config) { config.node = 1; })};
  Plant plant;
};

TEST_F(CanRules, EveryWayOutOfOperationSwitchesMotorsOffAtOnceAndNothingGoesOn) {
  for (const char* command : {kMove, kSpeed, kMotors}) {
    for (const char* out : {"000#0201", "000#8000", "011#0100"}) {
      host.send(command);
      wait(200);
      ASSERT_TRUE(has_power()) << command;
      host.send(out);
      EXPECT_FALSE(has_power()) << command << " " << out;
      wait(600);
      host.send("000#0101");
      wait(100);
      EXPECT_EQ(state(), EYECAN_STATE_OPERATIONAL);
      EXPECT_FALSE(has_power()) << command << " " << out;
    }
  }
}

TEST_F(CanRules, AStopEndsAMoveAsAbortedAndASpeedAsIdle) {
  EXPECT_EQ(move_state(), EYECAN_MOVE_IDLE);
  host.send(kMove);
  wait(100);
  EXPECT_EQ(move_state(), EYECAN_MOVE_RUNNING);
  host.send("000#0201");
  EXPECT_EQ(move_state(), EYECAN_MOVE_ABORTED);
  host.send("000#0101");
  host.send(kSpeed);
  EXPECT_EQ(move_state(), EYECAN_MOVE_SPEED);
  host.send("000#0201");
  EXPECT_EQ(move_state(), EYECAN_MOVE_IDLE);
}

TEST_F(CanRules, TheLastCommandCountsAndEndsTheOneBefore) {
  host.send(kMove);
  wait(100);
  host.send(kSpeed);
  EXPECT_EQ(move_state(), EYECAN_MOVE_SPEED);
  host.send("211#0108E80300006400");
  EXPECT_EQ(move_state(), EYECAN_MOVE_RUNNING);
  host.send(kMotors);
  EXPECT_EQ(move_state(), EYECAN_MOVE_ABORTED);
  host.send("211#0109640000006400");  // 100 mm
  wait(3000);
  EXPECT_EQ(move_state(), EYECAN_MOVE_DONE);
  host.send(kMotors);
  EXPECT_EQ(move_state(), EYECAN_MOVE_IDLE);
}

TEST_F(CanRules, MotorsThatAreNotInTheMaskKeepWhatTheyHaveButNotAfterASpeed) {
  host.send(kMotors);
  host.send("231#0000000001000000");
  EXPECT_EQ(host.board.pins.duty[0], 0);
  EXPECT_EQ(host.board.pins.duty[1], 5000);
  host.send(kSpeed);
  wait(200);
  host.send("231#3200000001000000");
  EXPECT_EQ(host.board.pins.duty[0], 5000);
  EXPECT_EQ(host.board.pins.duty[1], 0);
}

TEST_F(CanRules, ARepeatedSeqHasNoEffectWhateverElseItSaysUntilTheNextEnable) {
  host.send(kMove);
  EXPECT_EQ(speed_frame().substr(10, 2), "07");
  host.send("201#000000000100");
  wait(500);
  host.send("211#0207000084030A00");
  EXPECT_EQ(move_state(), EYECAN_MOVE_SPEED);
  host.send("000#0201");
  EXPECT_EQ(speed_frame().substr(10, 2), "07") << "stays";
  host.send("000#0101");
  host.send(kMove);
  EXPECT_EQ(move_state(), EYECAN_MOVE_RUNNING) << "the first one after ENABLE";
}

TEST_F(CanRules, TheFirstMoveMayHaveSeqZero) {
  host.send("211#0100E80300006400");
  EXPECT_EQ(move_state(), EYECAN_MOVE_RUNNING);
}

TEST_F(CanRules, AMoveWithNothingToDriveIsDoneAtOnce) {
  for (const char* move :
       {"211#0101E80300000000", "211#0102000084036400", "211#0203E80300006400"}) {
    host.send(move);
    EXPECT_EQ(move_state(), EYECAN_MOVE_DONE) << move;
  }
}

TEST_F(CanRules, ACurveWithoutDistanceIsATurnAndATurnHasNothingRemaining) {
  host.send("211#0301000084035A00");  // 90 degrees at 90 deg/s
  wait(100);
  EXPECT_EQ(speed_frame().substr(12, 4), "0000");
  wait(3000);
  EXPECT_EQ(move_state(), EYECAN_MOVE_DONE);
  EXPECT_NEAR(eb_drive_heading_cdeg(&host.board.drive), 9000, 100);
}

TEST_F(CanRules, EnablingARobotThatIsOperationalChangesNothing) {
  host.send(kMove);
  wait(200);
  host.send("000#0100");
  EXPECT_TRUE(has_power());
  EXPECT_EQ(move_state(), EYECAN_MOVE_RUNNING);
}

TEST_F(CanRules, OutsideOfOperationOnlyPoseGainsPortsAndEmergencyStopHaveAnEffect) {
  host.send("000#8000");
  host.frames();
  for (const char* command : {kMove, kSpeed, kMotors, "251#00FF000000000000", "261#00010001"}) {
    host.send(command);
  }
  EXPECT_FALSE(has_power());
  EXPECT_EQ(host.board.pins.servo_us[0], 0);
  EXPECT_EQ(host.board.pins.digital_out, 0);
  EXPECT_EQ(move_state(), EYECAN_MOVE_IDLE);
  wait(100);
  EXPECT_EQ(host.board.node.faults, 0) << "without a report";
  host.send("221#E8030030F8FF5046");
  EXPECT_THAT(host.frames(), ElementsAre("181#E8030030F8FFB0B9"));
  host.send("241#01010203");
  EXPECT_EQ(host.board.motors.motor[0].d, 3);
  host.send("271#0001");
  EXPECT_EQ(host.board.pins.digital_outputs & 1, 1);
  host.send("010#0100");
  EXPECT_EQ(state(), EYECAN_STATE_STOPPED);
}

TEST_F(CanRules, ASpeedOfZeroMustBeRepeatedAndAMoveEndsTheTimeOut) {
  host.send("201#000000000100");
  wait(300);
  EXPECT_EQ(speed_frame()[8], 'C') << "MotorsEnabled is 4, CommandTimeout 8";
  EXPECT_EQ(host.board.node.faults, EYECAN_FLAG_COMMAND_TIMEOUT);
  EXPECT_EQ(state(), EYECAN_STATE_OPERATIONAL);
  host.send(kMove);
  EXPECT_EQ(speed_frame()[8], '4');
  EXPECT_EQ(host.board.node.faults, 0);
}

TEST_F(CanRules, AResetEndsAnEmergencyStop) {
  host.send("011#0100");
  host.send("000#0101");
  EXPECT_EQ(state(), EYECAN_STATE_STOPPED);
  host.send("000#8101");
  EXPECT_THAT(host.frames(), ElementsAre("701#00", StartsWith("481#"), "701#7F"));
  host.send("000#0101");
  EXPECT_EQ(state(), EYECAN_STATE_OPERATIONAL);
  wait(100);
  EXPECT_EQ(host.board.node.faults, 0);
}

TEST_F(CanRules, AStopKeepsTheFaultOfAnEmergencyStop) {
  host.send("011#0100");
  host.send("000#8000");
  EXPECT_EQ(state(), EYECAN_STATE_STANDBY);
  wait(600);
  EXPECT_EQ(host.board.node.faults, EYECAN_FLAG_ESTOP);
}

TEST_F(CanRules, TheFirstFlagGivesTheCodeAndAnEventComesBeforeIt) {
  host.board.pins.supply_cv = 500;
  EXPECT_EQ(next("081"), "2031052000000000");
  host.send("011#0100");
  EXPECT_EQ(next("081"), "01FF112100000000");
  host.send("011#0000");
  EXPECT_EQ(next("081"), "2082112100110000") << "a reason that is none";
  EXPECT_EQ(next("081"), "01FF112100000000") << "the steady state again";
}

TEST_F(CanRules, WhatIsForOthersIsIgnoredWithoutAReport) {
  for (const char* frame :
       {"202#C8", "200#C80000000100", "7F1#05", "021#00", "702#01", "181#R", "012#00"}) {
    host.send(frame);
  }
  wait(100);
  EXPECT_EQ(host.board.node.event_code, 0);
  EXPECT_EQ(host.board.node.faults, 0);
  EXPECT_EQ(state(), EYECAN_STATE_OPERATIONAL);
}

TEST_F(CanRules, ARemoteFrameAsksForTheVersionAlone) {
  host.frames();
  for (const char* frame : {"181#R", "701#R", "482#R"}) host.send(frame);
  EXPECT_THAT(host.frames(), IsEmpty());
  host.send("481#R");
  EXPECT_THAT(host.frames(), ElementsAre(StartsWith("481#01")));
}

TEST_F(CanRules, OutputsShowInTheLevelsAndInputsDoNotShowInOut) {
  host.send("271#0001");
  host.send("261#FFFFFFFF");
  EXPECT_THAT(next("1F1"), StartsWith("FFFF01FF01FF"));
}

TEST_F(CanRules, WithoutAFaultThereIsNoFaultFrame) {
  host.frames();
  for (int i = 0; i < 20; ++i) {
    host.send("70F#05");
    host.wait_ms(100);
    EXPECT_THAT(host.frames(), testing::Not(Contains(StartsWith("081#"))));
  }
}

}  // namespace
}  // namespace eyebridge::firmware
