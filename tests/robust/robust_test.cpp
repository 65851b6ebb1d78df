// What happens to a robot that drives when its program, its board or its line goes away: processes
// of their own, killed and unplugged.
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/can.h>
#include <linux/can/error.h>

#include "loop.hpp"
#include "relay.hpp"

namespace eyebridge::testing {
namespace {

using ::testing::HasSubstr;

// The bound is 300 ms; a row of the path is 10 ms old, and one more passes before it is read.
constexpr double kStopped = 0.3 + 0.02;

class Robust : public ::testing::TestWithParam<Line> {
 protected:
  void expect_stop_within_300_ms_of(double moment) const {
    const auto since = loop.standing_since();
    ASSERT_TRUE(since) << "it still moves";
    EXPECT_LE(*since, moment + kStopped);
    RecordProperty("stop_ms", static_cast<int>(1000 * (*since - moment)));
  }
  Loop loop{GetParam()};
};

TEST_P(Robust, AProgramThatIsKilledLeavesAStandingRobot) {
  loop.start_program();
  const double killed = loop.time();
  EXPECT_EQ(loop.program().finish(SIGKILL), 128 + SIGKILL);
  expect_stop_within_300_ms_of(killed);
}

TEST_P(Robust, CtrlCStopsTheRobotAndEndsTheProgram) {
  loop.start_program();
  const double interrupted = loop.time();
  EXPECT_EQ(loop.program().finish(SIGINT), 128 + SIGINT);
  expect_stop_within_300_ms_of(interrupted);
}

TEST_P(Robust, ABoardThatIsKilledIsAnErrorAndIsFoundAgainStanding) {
  loop.start_program();
  loop.firmware().finish(SIGKILL);
  EXPECT_THAT(loop.program().wait_for("lost: "), HasSubstr("lost: "));
  loop.start_firmware();
  EXPECT_THAT(loop.program().wait_for("back\n"), HasSubstr("back\n"));
  EXPECT_TRUE(loop.standing_since()) << "nobody has commanded anything";
  EXPECT_TRUE(loop.moves()) << "the program's next command";
  loop.program().finish(SIGTERM);
}

TEST_P(Robust, ABoardThatHangsIsAnErrorAndGoesOnStanding) {
  loop.start_program();
  loop.firmware().signal(SIGSTOP);
  EXPECT_THAT(loop.program().wait_for("lost: "), HasSubstr("lost: "));
  bridges::MonotonicClock clock;
  clock.wait_until(std::chrono::seconds(2));  // a hiccup is something else
  loop.firmware().signal(SIGCONT);
  EXPECT_THAT(loop.program().wait_for("back\n"), HasSubstr("back\n"));
  EXPECT_TRUE(loop.standing_since()) << "nobody has commanded anything";
  EXPECT_TRUE(loop.moves()) << "the program's next command";
  loop.program().finish(SIGTERM);
}

std::vector<Line> lines() {
  std::vector<Line> all{
      {"PtyHostVw", {"--no-vw", "--pty", "./eyebot.tty"}},
      {"PtyBinary", {"--no-vw", "--binary", "--pty", "./eyebot.tty"}},
      {"Tcp", {"--no-vw", "--tcp", "47115"}},
      {"CanSocket29", {"--can", "./eyebot.bus", "--node", "3", "--ids", "29", "--offset", "4096"}}};
  if (const char* const can = std::getenv("EYEBRIDGE_TEST_CAN")) {
    const std::string name(can);
    all.push_back({"Vcan", {"--can", name.substr(0, name.find(',')), "--node", "3"}});
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Lines, Robust, ::testing::ValuesIn(lines()),
                         [](const auto& row) { return row.param.name; });

/// A CAN interface, in the lab's kernel.
class RobustCan : public ::testing::Test {
 protected:
  static std::string interface() {
    const std::string names = std::getenv("EYEBRIDGE_TEST_CAN");
    return names.substr(0, names.find(','));
  }
  static void set_link(const char* state) {
    const std::string command = "ip link set " + interface() + " " + state;
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
  }
  Loop loop{{"vcan", {"--can", interface(), "--node", "3"}}};
};

TEST_F(RobustCan, AnInterfaceThatGoesDownIsAnErrorAndTheRobotStops) {
  loop.start_program();
  const double down = loop.time();
  set_link("down");
  EXPECT_THAT(loop.program().wait_for("lost: "), HasSubstr(interface()));
  const auto since = loop.standing_since();
  ASSERT_TRUE(since);
  EXPECT_LE(*since, down + kStopped);
  set_link("up");
  EXPECT_THAT(loop.program().wait_for("back\n"), HasSubstr("back\n"));
  EXPECT_TRUE(loop.moves());
  loop.program().finish(SIGTERM);
}

/// What a controller's driver reports; vcan lets everybody send it.
void report(const std::string& interface, unsigned error_class) {
  const std::string text = "import socket,struct\ns=socket.socket(29,3,1)\ns.bind(('" + interface +
                           "',))\ns.send(struct.pack('=IB3x8s'," +
                           std::to_string(CAN_ERR_FLAG | error_class) + ",8,b''))";
  ASSERT_EQ(run_program({{"/usr/bin/python3", "-c", text}, {}, ""}).exit_code, 0);
}

TEST_F(RobustCan, AControllerThatIsBusOffIsNamedAndTheRobotStops) {
  loop.start_program();
  const double off = loop.time();
  report(interface(), CAN_ERR_BUSOFF);
  EXPECT_THAT(loop.program().wait_for("lost: "), HasSubstr("bus off"));
  const auto since = loop.standing_since();
  ASSERT_TRUE(since);
  EXPECT_LE(*since, off + kStopped);
  report(interface(), CAN_ERR_RESTARTED);
  EXPECT_THAT(loop.program().wait_for("back\n"), HasSubstr("back\n"));
  EXPECT_TRUE(loop.moves());
  loop.program().finish(SIGTERM);
}

/// A program whose board is behind a line that damages bytes once the board is found.
class RobustLine : public ::testing::TestWithParam<std::uint64_t> {
 protected:
  /// Runs it to its end; one byte in a hundred is dropped and another one flipped, both ways.
  void run(const std::string& command) {
    bridges::FaultPlan plan;
    plan.seed = GetParam();
    plan.incoming.drop = plan.outgoing.drop = 0.01;
    plan.incoming.flip = plan.outgoing.flip = 0.01;
    Relay relay(firmware.hal().substr(std::string("tcp:").size()), plan);
    RunningProgram program(
        {{command}, {{"EYEBRIDGE_HAL", relay.hal() + "?hdt=" + hdt}}, folder.path()});
    exit_code = program.wait();
    output = program.said();
    counts = relay.counts();
    end = firmware.stop();
  }

  const std::string world = EYEBRIDGE_SOURCE_DIR "/worlds/corridor.wld";
  ScratchFolder folder;
  const std::string hdt = folder.write("robot.hdt", firmware_hdt({"--world", world}));
  RunningFirmware firmware{{"--world", world, "--no-vw", "--tcp", "0"}};
  int exit_code = -1;
  std::string output;
  bridges::FaultCounts counts;
  Pose end;  // of the robot, really
};

TEST_P(RobustLine, TheWallFollowerEndsItsCourseThoughOneByteInFiftyIsLostOrFlipped) {
  run(EYEBRIDGE_BIN "/parity_follower");
  EXPECT_EQ(exit_code, 0) << output;
  EXPECT_THAT(output, HasSubstr("three corners after "));
  EXPECT_GT(counts.dropped, 500U);
  EXPECT_GT(counts.flipped, 500U);
  EXPECT_NEAR(end.x, 0.3, 0.15) << "before the third corner";
  EXPECT_NEAR(end.y, 2.1, 0.15);
  std::printf("off by %.0f mm; %u bytes dropped, %u flipped\n",
              1000 * std::hypot(end.x - 0.3, end.y - 2.1), static_cast<unsigned>(counts.dropped),
              static_cast<unsigned>(counts.flipped));
}

INSTANTIATE_TEST_SUITE_P(Seeds, RobustLine, ::testing::Range<std::uint64_t>(1, 4));

}  // namespace
}  // namespace eyebridge::testing
