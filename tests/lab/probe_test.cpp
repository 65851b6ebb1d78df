// `eyebridge probe` and `eyebridge doctor` where there are CAN interfaces.
#include <gmock/gmock.h>

#include "run_program.hpp"

namespace eyebridge::testing {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

/// Runs `script` in the guest, in simulated time, with our commands first in PATH. There,
/// `firmware NODE…` starts a process of boards on vcan0 and returns when they are there.
ProgramRun shell(const std::string& script) {
  const std::string prelude =
      "PATH=" EYEBRIDGE_BIN
      ":/usr/sbin:/sbin:$PATH; cd /tmp\n"
      "firmware() {\n"
      "  said=$(mktemp -u); mkfifo $said\n"
      "  eyebridge firmware --world " EYEBRIDGE_SOURCE_DIR
      "/worlds/two-robots.sim --can vcan0 \"$@\" >$said &\n"
      "  while read line; do case $line in *Ctrl-C*) break;; esac; done <$said\n"
      "}\n";
  return run_program({{EYEBRIDGE_LAB "/run", "--time-travel", "--timeout", "50", "--", "sh", "-c",
                       prelude + script},
                      {},
                      ""});
}

TEST(LabProbe, EachRobotOnABusIsToldWithHowToRunIt) {
  const ProgramRun run = shell("firmware --node 1 --node 3; eyebridge probe can:vcan0");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out,
              AllOf(HasSubstr("vcan0: virtual, no wire, CAN FD, queue of "),
                    HasSubstr("2 robots heard"), ContainsRegex("firmware +1.04, protocol 1\n"),
                    ContainsRegex("robot 1\n +state +standby"), ContainsRegex("robot 3\n +state "),
                    HasSubstr("eyebridge run --hal 'can:vcan0?node=3"), Not(HasSubstr("TWICE"))));
}

TEST(LabProbe, TwoRobotsWithOneNumberAreSaid) {
  const ProgramRun run = shell("firmware --node 2; firmware --node 2; eyebridge probe vcan0");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("1 robot heard"), HasSubstr("two robots have this number")));
}

TEST(LabProbe, ASilentBusIsRefused) {
  const ProgramRun run = shell("eyebridge probe can:vcan1");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("vcan1: no robot was heard for 1.5s; expected its heartbeat"));
}

TEST(LabProbe, AnInterfaceThatIsDownIsRefusedWithTheCommand) {
  const ProgramRun run = shell("ip link set vcan0 down; eyebridge probe can:vcan0");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.err, "eyebridge: vcan0: the interface is down; as root: ip link set vcan0 up\n");
}

TEST(LabProbe, AnInterfaceThatIsNotThereIsRefusedWithThoseThatAre) {
  const ProgramRun run = shell("eyebridge probe can:can9");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, AllOf(HasSubstr("can9: no such CAN interface"), HasSubstr("(errno 19)"),
                             HasSubstr("expected one of vcan0, vcan1")));
}

TEST(LabProbe, ANetworkInterfaceIsNoCanInterface) {
  const ProgramRun run = shell("eyebridge probe can:lo");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.err, "eyebridge: lo: is a network interface, but not for CAN\n");
}

TEST(LabProbe, TheListHasTheInterfaces) {
  const ProgramRun run = shell("eyebridge probe");
  EXPECT_THAT(run.out, AllOf(ContainsRegex("can:vcan0 +virtual, no wire, CAN FD"),
                             ContainsRegex("can:vcan1 +virtual")))
      << run.err;
}

/// What `eyebridge doctor` says of an adapter at 500 kbit/s once it has told `state` of its bus, as
/// the kernel's slcan driver takes it.
std::string doctor_with_adapter(const std::string& state) {
  const std::string program = R"(
import fcntl, os, pty, socket, struct, subprocess, termios, threading, tty
board, line = pty.openpty()
tty.setraw(line)
fcntl.ioctl(line, termios.TIOCSETD, struct.pack('i', 17))  # N_SLCAN
def take():  # what the driver tells the adapter, which would wait else
    while True: os.read(board, 100)
threading.Thread(target=take, daemon=True).start()
subprocess.check_call('ip link set can0 type can bitrate 500000 && ip link set can0 up', shell=True)
bus = socket.socket(socket.AF_CAN, socket.SOCK_RAW, socket.CAN_RAW)
bus.bind(('can0',))
os.write(board, b')" + state + R"(\rt12310F\r')
bus.recv(16)  # the frame behind it: so the state has been taken
subprocess.call(['eyebridge', 'doctor'])
)";
  const ProgramRun run = shell("/usr/bin/python3 -c \"$(cat <<'END'\n" + program + "END\n)\"");
  return run.out + run.err;
}

TEST(LabDoctor, TellsAnAdaptersBitRateAndState) {
  EXPECT_THAT(doctor_with_adapter("sa001002"), ContainsRegex("can0 +ok +500 kbit/s, error-active"));
}

TEST(LabDoctor, GivesHintsOnABusThatDamagesFrames) {
  EXPECT_THAT(doctor_with_adapter("sp001130"),
              AllOf(ContainsRegex("can0 +ok +500 kbit/s, error-passive"), HasSubstr("120 ohm")));
}

TEST(LabDoctor, CallsAnAdapterThatWentOffTheBusNone) {
  EXPECT_THAT(doctor_with_adapter("sb256256"),
              AllOf(ContainsRegex("can0 +none +500 kbit/s, bus-off"),
                    HasSubstr("ip link set can0 type can restart\n")));
}

}  // namespace
}  // namespace eyebridge::testing
