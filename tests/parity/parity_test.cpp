// One binary in the simulation and on firmware that speaks the protocols, in other processes: the
// robot must end at the same place.

#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "eyebridge/base/units.hpp"
#include "firmware_process.hpp"
#include "run_program.hpp"

namespace eyebridge {
namespace {

using testing::FirmwareProcess;
using ::testing::HasSubstr;
using testing::ProgramRun;
using testing::ScratchFolder;

constexpr int kMoves = 11;

/// The robot's own table, as a lecturer would keep it beside the robot.
std::string hdt_file(const ScratchFolder& folder) {
  const ProgramRun r = testing::run_program(
      {{EYEBRIDGE_BIN "/eyebridge", "firmware", "--world", EYEBRIDGE_WORLD, "--hdt"}, {}, ""});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  return folder.write("robot.hdt", r.out);
}

ProgramRun run_move(int move, std::map<std::string, std::string> settings) {
  return testing::run_program({{EYEBRIDGE_PROGRAM, std::to_string(move)}, settings, ""});
}

/// Where the robot really is at the end of the simulated run, and how long its way was.
struct Course {
  Pose end;
  double length = 0.0;
};
Course simulated(int move) {
  const ScratchFolder folder;
  const ProgramRun r = run_move(move, {{"EYEBRIDGE_WORLD", EYEBRIDGE_WORLD},
                                       {"EYEBRIDGE_FAST", "1"},
                                       {"EYEBRIDGE_OUT", folder.path()}});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  Course course;
  const std::string trace = testing::file_text(folder.path() + "/trace.csv");
  double t = 0;
  Pose pose;
  for (std::size_t row = trace.find('\n'); row != std::string::npos;
       row = trace.find('\n', row + 1)) {
    if (std::sscanf(trace.c_str() + row + 1, "%lf,%lf,%lf,%lf", &t, &pose.x, &pose.y,
                    &pose.theta) != 4)
      break;
    if (course.end != Pose{}) course.length += norm(pose.position() - course.end.position());
    course.end = pose;
  }
  return course;
}

struct Board {
  const char* name;
  std::vector<std::string> options;  ///< Of the firmware; "PTY" stands for a name.
  const char* url_options;
};
void PrintTo(const Board& board, std::ostream* out) { *out << board.name; }

class Parity : public ::testing::TestWithParam<Board> {
 protected:
  std::vector<std::string> options() const {
    std::vector<std::string> out = GetParam().options;
    for (std::string& word : out) {
      if (word == "PTY") word = folder_.path() + "/eyebot.tty";
    }
    return out;
  }
  ScratchFolder folder_;
  std::string hdt_ = hdt_file(folder_);
};

TEST_P(Parity, TheRobotEndsWhereTheSimulatedOneDoes) {
  for (int move = 0; move < kMoves; ++move) {
    const Course expected = simulated(move);
    FirmwareProcess firmware(options());
    const ProgramRun r = run_move(
        move, {{"EYEBRIDGE_HAL", firmware.hal() + "?hdt=" + hdt_ + GetParam().url_options}});
    EXPECT_EQ(r.exit_code, 0) << r.err;
    EXPECT_THAT(r.out, ::testing::Not(HasSubstr("missed"))) << "move " << move;
    EXPECT_EQ(r.err, "") << "move " << move;
    const Pose end = firmware.stop();
    const double off = norm(end.position() - expected.end.position());
    const double turned = rad_to_deg(std::abs(wrap_angle(end.theta - expected.end.theta)));
    std::printf("| %s | %d | %.0f | %.1f | %.2f |\n", GetParam().name, move,
                m_to_mm(expected.length), m_to_mm(off), turned);
    // A turn on the spot has no path; two millimetres are what its wheels' ends round to.
    EXPECT_LE(off, std::max(0.02 * expected.length, 0.002)) << "move " << move;
    EXPECT_LE(turned, 2.0) << "move " << move;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Boards, Parity,
    ::testing::Values(Board{"PtyHostVw", {"--no-vw", "--pty", "PTY"}, ""},
                      Board{"PtyBoardVw", {"--pty", "PTY"}, "&profile=io7vw"},
                      Board{"PtyBinary", {"--binary", "--lsb", "--pty", "PTY"}, ""},
                      Board{
                          "PtyText", {"--verbose", "--prompt", "--pty", "PTY"}, "&profile=io7vw"}),
    [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace eyebridge
