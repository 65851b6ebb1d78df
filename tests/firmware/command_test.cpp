#include <array>
#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <poll.h>
#include <unistd.h>

#include "eyebridge/base/unique_fd.hpp"
#include "running_firmware.hpp"

namespace eyebridge::firmware {
namespace {

using eyebridge::testing::firmware_command;
using eyebridge::testing::run_program;
using eyebridge::testing::RunningFirmware;
using ::testing::HasSubstr;

constexpr int kPatience_ms = 60'000;
const std::string kWorlds = EYEBRIDGE_SOURCE_DIR "/worlds/";

std::string ask(int host, const std::string& request, std::size_t size) {
  std::string answer;
  if (::write(host, request.data(), request.size()) < 0) return answer;
  pollfd ready{host, POLLIN, 0};
  std::array<char, 256> buffer{};
  while (answer.size() < size && ::poll(&ready, 1, kPatience_ms) > 0) {
    const ssize_t got = ::read(host, buffer.data(), buffer.size());
    if (got <= 0) break;
    answer.append(buffer.data(), static_cast<std::size_t>(got));
  }
  return answer;
}

int counter_of(const std::string& bytes) {
  return static_cast<unsigned char>(bytes.at(0)) << 8 | static_cast<unsigned char>(bytes.at(1));
}

TEST(FirmwareCommand, DrivesTheRobotsOfAWorldOverPseudoTerminals) {
  const eyebridge::testing::ScratchFolder folder;
  RunningFirmware firmware({"--world", kWorlds + "two-robots.sim", "--pty", "./one.tty", "--pty",
                            "./two.tty", "--trace", "trace.txt"},
                           folder.path());
  const std::string said = firmware.wait_for("Ctrl-C ends\n");
  EXPECT_THAT(said, HasSubstr("robot 1: eyebridge run --hal serial:./one.tty PROGRAM\n"));
  EXPECT_THAT(said, HasSubstr("robot 2: eyebridge run --hal serial:./two.tty PROGRAM\n"));
  UniqueFd host(::open((folder.path() + "/two.tty").c_str(), O_RDWR | O_NOCTTY));
  ASSERT_TRUE(host.valid());
  EXPECT_EQ(ask(host.get(), "v\r", 4), "1.04");
  ask(host.get(), "M 1 20\rM 2 20\rv\r", 4);
  int ticks = 0;  // asking goes on, so that no watchdog stops it
  for (int i = 0; i < 100'000 && (ticks < 40 || ticks > 32767); ++i) {
    ticks = counter_of(ask(host.get(), "e 1\r", 2));
  }
  EXPECT_GE(ticks, 40);
  EXPECT_EQ(firmware.finish(SIGTERM), 0);
  EXPECT_FALSE(std::filesystem::exists(folder.path() + "/two.tty"));
  EXPECT_THAT(eyebridge::testing::file_text(folder.path() + "/trace.txt"), HasSubstr(" < 760D\n"));
}

TEST(FirmwareCommand, ServesTcpAndSpeaksAsTold) {
  const eyebridge::testing::ScratchFolder folder;
  RunningFirmware firmware({"--world", kWorlds + "maze-5.maz", "--tcp", "0", "--verbose"},
                           folder.path());
  EXPECT_THAT(firmware.wait_for("Ctrl-C ends\n"), HasSubstr("--hal tcp:127.0.0.1:"));
  EXPECT_EQ(firmware.finish(SIGINT), 0);
}

TEST(FirmwareCommand, PrintsAnHdtFile) {
  const auto run =
      run_program({firmware_command({"--world", kWorlds + "maze-5.maz", "--hdt"}), {}, {}});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.out, HasSubstr("TABLE PSD_Table\n"));
}

struct Wrong {
  std::vector<std::string> arguments;
  const char* message;
};

TEST(FirmwareCommand, SaysInOneLineWhatIsWrong) {
  const std::string maze = kWorlds + "maze-5.maz";
  const Wrong all[] = {
      {{"--world", maze}, "firmware: found no board, expected --pty, --tcp or --can"},
      {{"--world", "/none.maz", "--pty", "x"}, "/none.maz"},
      {{"--world", maze, "--robot", "R2D2", "--tcp", "0"}, "--robot"},
      {{"--world", maze, "--tcp", "0", "--tcp", "0"}, "expected one for each of 2 boards"},
      {{"--world", maze, "--tcp", "99999"}, "--tcp: found '99999'"},
      {{"--world", maze, "--node", "1"}, "--node: found no --can"},
      {{"--world", maze, "--can", "can0"},
       "--can: found no --node, expected a number 1 to 14, or --rover"},
      {{"--world", maze, "--rover"}, "--rover: found no --can"},
      {{"--world", maze, "--can", "can0", "--node", "15"}, "15"},
      {{"--world", maze, "--can", "c", "--node", "1", "--ids", "12"}, "--ids"},
      {{"--world", maze, "--can", "c", "--node", "1", "--offset", "241"},
       "--offset: found 241, expected 0 to 240, or --ids 29"},
      {{"--world", maze, "--tcp", "0", "--ids", "29"}, "--can"},
      {{"--world", maze, "--can", "nocan7", "--node", "1"}, "errno"},
      {{"--world", maze, "--pty", "/no/such/folder/tty"}, "--pty: cannot make"},
      {{"--world", maze, "--tcp", "0", "--raw", "--verbose"}, "excludes"},
      {{"--world", maze, "--tcp", "0", "--trace", "/no/such/file"}, "--trace"},
  };
  for (const Wrong& wrong : all) {
    const auto run = run_program({firmware_command(wrong.arguments), {}, {}});
    EXPECT_EQ(run.exit_code, 2) << wrong.message;
    EXPECT_THAT(run.err, HasSubstr(wrong.message));
    EXPECT_EQ(run.out, "");
  }
}

}  // namespace
}  // namespace eyebridge::firmware
