// `eyebridge firmware --cortex-m3` as a process, and what is missing or wrong.
#include <charconv>
#include <csignal>
#include <filesystem>
#include <sstream>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <poll.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "cortex_rig.hpp"
#include "eyebridge/base/config_error.hpp"
#include "running_firmware.hpp"

namespace eyebridge::mps2 {
namespace {

namespace fs = std::filesystem;
using eyebridge::testing::file_text;
using eyebridge::testing::kCommand;
using eyebridge::testing::run_program;
using eyebridge::testing::RunningFirmware;
using eyebridge::testing::ScratchFolder;
using ::testing::HasSubstr;

constexpr int kPatience_ms = 60'000;
const std::string kMaze = EYEBRIDGE_SOURCE_DIR "/worlds/maze-5.maz";

/// The process that `parent` has started; 0 when there is none.
pid_t child_of(pid_t parent) {
  for (const auto& entry : fs::directory_iterator("/proc")) {
    const std::string name = entry.path().filename();
    pid_t pid = 0;
    std::from_chars(name.data(), name.data() + name.size(), pid);
    const std::string status = pid > 0 ? file_text(entry.path() / "stat") : "";
    const std::size_t end = status.rfind(')');  // of the name, which can hold anything
    if (end == std::string::npos) continue;
    std::istringstream rest(status.substr(end + 1));
    std::string state;
    pid_t its_parent = 0;
    if (rest >> state >> its_parent && its_parent == parent) return pid;
  }
  return 0;
}

/// A descriptor that is ready when the process is over; -1 when there is no such process.
int process_fd(pid_t pid) { return static_cast<int>(::syscall(SYS_pidfd_open, pid, 0)); }

/// Waits until a process is over.
bool is_over(const UniqueFd& process) {
  pollfd over{process.get(), POLLIN, 0};
  return ::poll(&over, 1, kPatience_ms) == 1;
}

TEST(CortexCommand, DrivesTheRobotOfAWorldAndSaysAtTheEndWhereItIs) {
  const ScratchFolder folder;
  RunningFirmware running(
      {"--cortex-m3", "--world", kMaze, "--pty", "./one.tty", "--trace", "trace.txt"},
      folder.path());
  EXPECT_THAT(running.wait_for("Ctrl-C ends\n"),
              HasSubstr("robot 1: eyebridge run --hal serial:./one.tty PROGRAM\n"));
  const UniqueFd emulator(process_fd(child_of(running.pid())));
  ASSERT_TRUE(emulator.valid());
  const UniqueFd host(::open((folder.path() + "/one.tty").c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC));
  ASSERT_EQ(::write(host.get(), "v\r", 2), 2);
  std::string version;
  pollfd ready{host.get(), POLLIN, 0};
  while (version.size() < 4 && ::poll(&ready, 1, kPatience_ms) > 0) {
    char byte = 0;
    if (::read(host.get(), &byte, 1) == 1) version += byte;
  }
  EXPECT_EQ(version, "1.04");
  EXPECT_EQ(::kill(running.pid(), SIGINT), 0);
  EXPECT_THAT(running.wait_for(" degrees\n"), HasSubstr("\nrobot 1 at "));
  EXPECT_EQ(running.wait(), 0);
  EXPECT_TRUE(is_over(emulator));
  EXPECT_FALSE(fs::exists(folder.path() + "/one.tty"));
  EXPECT_THAT(file_text(folder.path() + "/trace.txt"), HasSubstr(" < 760D\n"));
}

TEST(CortexCommand, TheEmulatorDoesNotOutliveAKilledParent) {
  const ScratchFolder folder;
  RunningFirmware running({"--cortex-m3", "--world", kMaze, "--tcp", "0"}, folder.path());
  EXPECT_THAT(running.wait_for("Ctrl-C ends\n"), HasSubstr("--hal tcp:127.0.0.1:"));
  const pid_t pid = child_of(running.pid());
  const UniqueFd emulator(process_fd(pid));
  ASSERT_TRUE(emulator.valid());
  EXPECT_EQ(running.finish(SIGKILL), 128 + SIGKILL);
  const bool over = is_over(emulator);
  EXPECT_TRUE(over);
  if (!over) ::kill(pid, SIGKILL);
}

TEST(CortexCommand, EndsWithAnErrorWhenTheEmulatorDies) {
  const ScratchFolder folder;
  RunningFirmware running({"--cortex-m3", "--world", kMaze, "--pty", "./one.tty"}, folder.path());
  running.wait_for("Ctrl-C ends\n");
  ASSERT_EQ(::kill(child_of(running.pid()), SIGKILL), 0);
  EXPECT_EQ(running.wait(), 1);
  EXPECT_FALSE(fs::exists(folder.path() + "/one.tty"));
}

struct Wrong {
  std::vector<std::string> arguments;
  const char* message;
};

TEST(CortexCommand, SaysInOneLineWhatIsWrong) {
  const Wrong all[] = {
      {{"--cortex-m3", "--tcp", "0", "--tcp", "0"}, "--cortex-m3: found 2 boards, expected one"},
      {{"--cortex-m3", "--can", "can0", "--node", "1"}, "the emulated board has no CAN"},
      {{"--elf", "x", "--tcp", "0"}, "--elf: found no --cortex-m3"},
      {{"--cortex-m3", "--tcp", "0", "--elf", "/none.elf"},
       "/none.elf: cannot be read: No such file or directory; expected the firmware of the "
       "emulated board: install gcc-arm-none-eabi and libnewlib-arm-none-eabi"},
      {{"--cortex-m3", "--tcp", "0", "--elf", kMaze}, "is no program for an ARM processor"},
      {{"--cortex-m3", "--tcp", "0", "--elf", kCommand}, "is no program for an ARM processor"},
      {{"--cortex-m3", "--tcp", "99999"}, "--tcp: found '99999'"},
  };
  for (const Wrong& wrong : all) {
    std::vector<std::string> command{kCommand, "firmware", "--world", kMaze};
    command.insert(command.end(), wrong.arguments.begin(), wrong.arguments.end());
    const auto run = run_program({command, {}, {}});
    EXPECT_EQ(run.exit_code, 2) << wrong.message;
    EXPECT_THAT(run.err, HasSubstr(wrong.message));
    EXPECT_EQ(run.out, "");
  }
}

TEST(CortexCommand, NamesThePackageOfAMissingEmulator) {
  const ScratchFolder folder;
  const auto run =
      run_program({{kCommand, "firmware", "--world", kMaze, "--cortex-m3", "--tcp", "0"},
                   {{"PATH", folder.path()}},
                   {}});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.err,
            "eyebridge: qemu-system-arm: cannot start: No such file or directory; expected the "
            "emulator of the Cortex-M3: install qemu-system-arm\n");
}

TEST(CortexCommand, AFirmwareThatCannotRunIsAnErrorAtTheStart) {
  const ScratchFolder folder;
  std::string elf = file_text(EYEBRIDGE_CORTEX_ELF);
  ASSERT_GT(elf.size(), 1000u);
  // The vectors begin with the stack's top, the end of the data memory; without them nothing runs.
  const std::size_t stack_top = elf.find(std::string("\x00\x00\x40\x20", 4));
  ASSERT_NE(stack_top, std::string::npos);
  elf.replace(stack_top, 64, std::string(64, '\0'));
  const std::string path = folder.write("broken.elf", elf);
  const auto run = run_program(
      {{kCommand, "firmware", "--world", kMaze, "--cortex-m3", "--tcp", "0", "--elf", path},
       {},
       {}});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("eyebridge: " + path + ": "));
}

}  // namespace
}  // namespace eyebridge::mps2
