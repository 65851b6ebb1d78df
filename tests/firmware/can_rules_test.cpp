// What SPECIFICATION.md says of CAN beside its tables and no other node can see: what motors,
// servos and ports do. The rest is in can_dialogues_test.cpp.
#include <algorithm>

#include <gmock/gmock.h>

#include "board_fixture.hpp"
#include "opcodes.h"

namespace eyebridge::firmware {
namespace {

using testing::ElementsAre;
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
  int move_state() { return next("191")[9] - '0'; }
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

TEST_F(CanRules, TheFirstFlagGivesTheCodeAndAnEventComesBeforeIt) {
  host.board.pins.supply_cv = 500;
  EXPECT_EQ(next("081"), "2031052000000000");
  host.send("011#0100");
  EXPECT_EQ(next("081"), "01FF112100000000");
  host.send("011#0000");
  EXPECT_EQ(next("081"), "2082112100110000") << "a reason that is none";
  EXPECT_EQ(next("081"), "01FF112100000000") << "the steady state again";
}

TEST_F(CanRules, OutputsShowInTheLevelsAndInputsDoNotShowInOut) {
  host.send("271#0001");
  host.send("261#FFFFFFFF");
  EXPECT_THAT(next("1F1"), StartsWith("FFFF01FF01FF"));
}

}  // namespace
}  // namespace eyebridge::firmware
