// `eyebridge probe`, as a user types it.
#include <algorithm>
#include <csignal>
#include <thread>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <poll.h>
#include <sys/file.h>
#include <termios.h>
#include <unistd.h>

#include "command.hpp"
#include "eyebridge/base/unique_fd.hpp"
#include "fake_machine.hpp"
#include "running_firmware.hpp"

namespace eyebridge {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using testing::FakeMachine;
using ::testing::HasSubstr;
using testing::ProgramRun;
using testing::run_command;
using testing::RunningFirmware;
using testing::ScratchFolder;

const std::string kProbeMaze = EYEBRIDGE_SOURCE_DIR "/worlds/maze-5.maz";

class Probe : public ::testing::Test {
 protected:
  ProgramRun probe(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "probe");
    return run_command(arguments, folder_.path());
  }
  /// One line says what is wrong, and the exit code is that of bad input.
  void expect_refusal(const std::vector<std::string>& arguments, const std::string& message) {
    const ProgramRun r = probe(arguments);
    EXPECT_EQ(r.exit_code, 2) << r.err;
    EXPECT_THAT(r.err, HasSubstr(message));
    EXPECT_EQ(std::count(r.err.begin(), r.err.end(), '\n'), 1) << r.err;
  }

  ScratchFolder folder_;
};

TEST_F(Probe, TellsWhatABoardOnASerialPortIs) {
  RunningFirmware board({"--world", kProbeMaze, "--pty", "./eyebot.tty", "--verbose", "--prompt"},
                        folder_.path());
  EXPECT_EQ(board.hal(), "serial:./eyebot.tty");
  const ProgramRun r = probe({"./eyebot.tty", "--trace", "trace.txt"});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, AllOf(HasSubstr("./eyebot.tty: an EyeBot I/O board (IO7), version 1.04\n"),
                           ContainsRegex("supply +[0-9.]+ V\n"), ContainsRegex("prompt +'>'\n"),
                           HasSubstr("most significant byte first: the supply"),
                           HasSubstr("by the host, over M and e"), HasSubstr("20 of 20 times"),
                           HasSubstr("eyebridge run --hal serial:./eyebot.tty PROGRAM\n"),
                           HasSubstr("'serial:./eyebot.tty?profile=io7vw'")));
  const std::string trace = testing::file_text(folder_.path() + "/trace.txt");
  EXPECT_THAT(trace, HasSubstr(" > 680D\n")) << "h";
  for (const char* moving : {" > 6D", " > 4D", " > 45", " > 78", " > 79", " > 59", " > 43"}) {
    EXPECT_THAT(trace, ::testing::Not(HasSubstr(moving)));
  }
  EXPECT_EQ(board.finish(SIGTERM), 0);
}

TEST_F(Probe, TellsWhatABoardBehindATcpPortIs) {
  RunningFirmware board({"--world", kProbeMaze, "--tcp", "0", "--lsb", "--no-vw", "--binary"});
  const ProgramRun r = probe({board.hal()});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, AllOf(HasSubstr("least significant byte first"),
                           ContainsRegex("requests +letters and bytes\n"),
                           ::testing::Not(HasSubstr("io7vw"))));
}

/// A pseudo-terminal with something at its other end, in this process.
class Terminal {
 public:
  Terminal() : master_(posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)) {
    char name[128] = {};
    if (grantpt(master_.get()) == 0 && unlockpt(master_.get()) == 0 &&
        ptsname_r(master_.get(), name, sizeof name) == 0) {
      device_ = name;
    }
    held_.reset(::open(name, O_RDWR | O_NOCTTY | O_CLOEXEC));
    termios raw{};
    tcgetattr(held_.get(), &raw);
    cfmakeraw(&raw);
    tcsetattr(held_.get(), TCSANOW, &raw);
  }
  ~Terminal() { stop(); }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// Answers `text` to whatever comes, until stop().
  void answer(const std::string& text) {
    int ends[2];
    ASSERT_EQ(pipe2(ends, O_CLOEXEC), 0);
    stop_.reset(ends[1]);
    thread_ = std::thread([this, text, listener = UniqueFd(ends[0])] {
      char buffer[256];
      while (true) {
        pollfd ready[2] = {{master_.get(), POLLIN, 0}, {listener.get(), POLLIN, 0}};
        if (::poll(ready, 2, -1) <= 0 || ready[1].revents != 0) return;
        if (::read(master_.get(), buffer, sizeof buffer) <= 0) return;
        if (::write(master_.get(), text.data(), text.size()) <= 0) return;
      }
    });
  }
  void stop() {
    stop_.reset();
    if (thread_.joinable()) thread_.join();
  }
  [[nodiscard]] const std::string& device() const { return device_; }
  [[nodiscard]] int host() const { return held_.get(); }

 private:
  UniqueFd master_;
  UniqueFd held_;
  UniqueFd stop_;
  std::string device_;
  std::thread thread_;
};

TEST_F(Probe, ASilentDeviceIsNoBoard) {
  const Terminal terminal;
  expect_refusal({terminal.device(), "--patience", "0s"}, terminal.device() + ": nothing answers");
}

TEST_F(Probe, ADeviceThatSpeaksSomethingElseIsNoBoard) {
  Terminal terminal;
  terminal.answer("ERROR\r\n");
  expect_refusal({terminal.device(), "--patience", "0s"}, "found 'ERROR");
}

TEST_F(Probe, ABusyPortIsRefusedWithTheNameOfWhoHoldsIt) {
  const Terminal terminal;
  ASSERT_EQ(::flock(terminal.host(), LOCK_EX | LOCK_NB), 0);
  expect_refusal({terminal.device()}, "(process " + std::to_string(::getpid()) + ")");
}

TEST_F(Probe, WhatIsNoDeviceIsRefusedWithOneClearMessage) {
  const std::string file = folder_.write("file", "");
  expect_refusal({"/dev/ttyACM77"}, "/dev/ttyACM77: no such device; expected");
  expect_refusal({file}, file + ": not a serial port");
  expect_refusal({"/dev/null"}, "/dev/null: not a serial port");
  expect_refusal({folder_.path()}, folder_.path() + ": ");
  expect_refusal({"sim:"}, "found another kind of device, expected");
  expect_refusal({"serial:"}, "expected the device of a serial port");
  expect_refusal({"serial:/dev/null?bad=1"}, "found the option 'bad'");
  expect_refusal({"serial:/dev/null?baud=fast"}, "'baud'");
  expect_refusal({"tcp:127.0.0.1:1"}, "connection refused");
  expect_refusal({"/dev/null", "--patience", "soon"}, "--patience");
  expect_refusal({"/dev/null", "--trace", "/no/such/file"}, "--trace");
}

TEST_F(Probe, ATraceReplacesOnlyATrace) {
  const std::string work = folder_.write("work.c", "int main() { return 0; }\n");
  expect_refusal({"/dev/null", "--trace", work}, "--trace: cannot write " + work +
                                                     ": found another kind of file, expected a new "
                                                     "name, or an earlier trace");
  EXPECT_EQ(testing::file_text(work), "int main() { return 0; }\n");
}

TEST_F(Probe, ACanInterfaceThatCannotBeUsedIsRefusedWithTheReasonsNumber) {
  const ProgramRun r = probe({"can:nocan7"});
  EXPECT_EQ(r.exit_code, 2);
  EXPECT_THAT(r.err, ContainsRegex("nocan7: .*\\(errno (97|93|19)\\)"));
}

TEST_F(Probe, WithoutADeviceItListsWhatThereIs) {
  const FakeMachine machine;
  machine.add_acm();
  machine.add_can("can0", true, 10, 72);
  const ProgramRun r = probe({"--root", machine.root()});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, AllOf(ContainsRegex("/dev/ttyACM0 +Interface Board \\(03eb:2404\\)"),
                           HasSubstr("/dev/serial/by-id/usb-UWA_Interface_Board-if00"),
                           ContainsRegex("can:can0 +.*CAN FD"),
                           HasSubstr("eyebridge probe /dev/ttyACM0\n")));
}

TEST_F(Probe, AMachineWithoutDevicesIsTold) {
  const FakeMachine machine;
  const ProgramRun r = probe({"--root", machine.root()});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("Found no serial port"));
}

}  // namespace
}  // namespace eyebridge
