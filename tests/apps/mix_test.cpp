// `--mix`, as a user types it: a board's wheels in a simulated world's corridor.
#include <csignal>
#include <sstream>

#include <gmock/gmock.h>

#include "command.hpp"
#include "running_firmware.hpp"

namespace eyebridge {
namespace {

using ::testing::HasSubstr;
using testing::ProgramRun;
using testing::run_shell;
using testing::RunningFirmware;
using testing::ScratchFolder;

TEST(MixCommand, SimulatedSensorsSeeWhatABoardsWheelsDo) {
  const ScratchFolder folder;
  // The board is in a room of its own, far from any wall; the program's world has one ahead.
  const std::string open_field =
      folder.write("field.wld", "floor 9000 9000\nposition 4500 4500 0\n");
  folder.write("room.wld", "floor 4000 2000\n2000 0 2000 2000\nposition 1000 1000 0\n");
  folder.write("eyebridge.toml",
               "hal = 'serial:./eyebot.tty'\nworld = 'room.wld'\n[mix]\npsd = 'sim'\n");
  folder.write("prog.c",
               "#include \"eyebot.h\"\n#include <stdio.h>\n"
               "int main(void) {\n  printf(\"%d \", PSDGet(1));\n  VWStraight(300, 300);\n"
               "  VWWait();\n  printf(\"%d\\n\", PSDGet(1));\n  return 0;\n}\n");
  RunningFirmware board({"--world", open_field, "--pty", "./eyebot.tty"}, folder.path());
  EXPECT_EQ(board.hal(), "serial:./eyebot.tty");
  const ProgramRun r = run_shell(
      "eyebridge-cc prog.c -o prog\nunset EYEBRIDGE_FAST\neyebridge run ./prog\n", folder.path());
  ASSERT_EQ(r.exit_code, 0) << r.err;
  int before = 0;
  int after = 0;
  std::istringstream(r.out) >> before >> after;
  EXPECT_NEAR(before, 1000 - 60, 1) << "an S4's front sensor sits 60 mm ahead of its centre";
  EXPECT_NEAR(before - after, 300, 15);
  EXPECT_EQ(board.finish(SIGTERM), 0);
}

TEST(MixCommand, BadMixesAreRefusedBeforeAnythingIsStarted) {
  const ScratchFolder folder;
  for (const auto& [mix, message] : {std::pair{"wings=sim", "found 'wings' as a device"},
                                     {"psd=moon", "unknown backend 'moon'"},
                                     {"psd", "found no backend for 'psd'"},
                                     {"psd=sim:x", "expected sim alone"}}) {
    const ProgramRun r = testing::run_command({"run", "--mix", mix, "/bin/true"}, folder.path());
    EXPECT_EQ(r.exit_code, 2);
    EXPECT_THAT(r.err, HasSubstr("--mix"));
    EXPECT_THAT(r.err, HasSubstr(message));
  }
}

}  // namespace
}  // namespace eyebridge
