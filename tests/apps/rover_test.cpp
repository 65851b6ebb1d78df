// A robot that EyeBridge knows by its DBC file alone, as a user drives it.
#include <csignal>

#include <gmock/gmock.h>

#include "command.hpp"
#include "eyebridge/base/math.hpp"
#include "eyebridge/base/units.hpp"
#include "running_firmware.hpp"

namespace eyebridge {
namespace {

using ::testing::HasSubstr;
using testing::ProgramRun;
using testing::RunningFirmware;
using testing::RunningProgram;
using testing::ScratchFolder;

const std::string kRover = EYEBRIDGE_SOURCE_DIR "/examples/rover/rover.";
const std::string kUrl = "can:./rover.bus?dbc=" + kRover + "dbc&map=" + kRover + "toml";

/// A rover in the middle of an empty room, on a bus in `folder`.
std::vector<std::string> rover_arguments(const ScratchFolder& folder) {
  return {"--world", folder.write("room.wld", "floor 4000 4000\nposition 2000 2000 0\n"), "--can",
          "./rover.bus", "--rover"};
}

TEST(RoverCommand, SquareEndsWhereItBegan) {
  const ScratchFolder folder;
  RunningFirmware rover(rover_arguments(folder), folder.path());
  EXPECT_THAT(rover.wait_for("Ctrl-C ends\n"),
              HasSubstr("--hal 'can:./rover.bus?dbc=FILE.dbc&map=FILE.toml' PROGRAM"));
  const ProgramRun r =
      testing::run_command({"run", "--hal", kUrl, EYEBRIDGE_SQUARE}, folder.path());
  EXPECT_EQ(r.exit_code, 0) << r.err;
  int x = 0;
  int y = 0;
  int degrees = 0;
  const std::size_t back = r.out.find("back at");
  ASSERT_NE(back, std::string::npos) << r.out;
  ASSERT_EQ(std::sscanf(r.out.c_str() + back, "back at %d %d, %d deg", &x, &y, &degrees), 3);
  constexpr double kWay = 3.2;  // metres driven
  EXPECT_LE(std::hypot(x, y), 1000 * kWay * 0.02) << r.out;
  EXPECT_LE(std::abs(degrees), 2) << r.out;
  const Pose end = rover.stop();
  EXPECT_LE(norm(end.position() - Vec2{2.0, 2.0}), kWay * 0.02);
  EXPECT_LE(std::abs(wrap_angle(end.theta)), deg_to_rad(2));
}

TEST(RoverCommand, AProgramThatIsKilledLeavesAStandingRobot) {
  const ScratchFolder folder;
  RunningFirmware rover(rover_arguments(folder), folder.path());
  rover.wait_for("Ctrl-C ends\n");
  RunningProgram program(
      {{testing::kCommand, "run", "--hal", kUrl, EYEBRIDGE_TEST_DRIVES_ON}, {}, folder.path()});
  EXPECT_THAT(program.wait_for("it drives\n"), HasSubstr("it drives"));
  program.signal(SIGKILL);
  EXPECT_THAT(program.wait_for("confirmed"), HasSubstr("the robot stands, confirmed"));
  EXPECT_EQ(program.wait(), 128 + SIGKILL);
  const Pose end = rover.stop();
  EXPECT_GT(end.x, 2.04);
  EXPECT_LT(end.x, 3.9) << "the wall";
}

TEST(RoverCommand, MistakesAreToldBeforeAnythingIsSent) {
  const ScratchFolder folder;
  const std::string map = folder.write("bad.toml", "[robot]\nwheel_base = 0\n");
  std::string fd_text = testing::file_text(kRover + "dbc");
  fd_text.replace(fd_text.find("RV_State: 6"), 11, "RV_State: 12");
  const std::string fd = folder.write("fd.dbc", fd_text);
  for (const auto& [url, message] : std::initializer_list<std::pair<std::string, std::string>>{
           {"can:can0?dbc=" + kRover + "dbc", "found 'dbc' without 'map', expected both"},
           {"can:can0?map=x", "found 'map' without 'dbc'"},
           {kUrl + "&node=1", "found 'node' beside 'dbc'"},
           {kUrl + "&hdt=x", "found 'hdt' beside 'dbc'"},
           {"can:can0?dbc=" + kRover + "dbc&map=" + map,
            "bad.toml:2:14: found 0 for 'wheel_base' in [robot]"},
           {"can:can0?dbc=/none.dbc&map=" + map, "/none.dbc: no such file"},
           {"can:can0?dbc=" + fd + "&map=" + kRover + "toml",
            "found RV_State, a message of CAN FD, expected the option fd=1"},
           {kUrl, "./rover.bus: nobody serves a bus there"}}) {
    const ProgramRun r =
        testing::run_command({"run", "--hal", url, EYEBRIDGE_SQUARE}, folder.path());
    EXPECT_EQ(r.exit_code, 2) << url;
    EXPECT_THAT(r.err, HasSubstr(message)) << url;
  }
}

}  // namespace
}  // namespace eyebridge
