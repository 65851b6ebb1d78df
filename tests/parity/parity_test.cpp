// One binary in the simulation and on firmware that speaks the protocols, in other processes and in
// real time: the robot must end at the same place.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <future>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/base/units.hpp"
#include "running_firmware.hpp"
#include "simulated_robot.hpp"

namespace eyebridge::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// A kind of board behind a kind of line.
struct Board {
  std::string name;
  std::vector<std::string> options;  ///< Of the firmware; NODE is filled in.
  std::string url_options;           ///< Of --hal.
  std::size_t at_once = 13;          ///< So many boards; they wait for real time nearly always.
};
void PrintTo(const Board& board, std::ostream* out) { *out << board.name; }

/// The program on a board of its own: where its robot ends, and what the program said.
struct BoardRun {
  Pose end;
  int exit_code = -1;
  std::string said;
};
BoardRun run_on(const Board& board, const Task& task, int node) {
  const ScratchFolder folder;
  std::vector<std::string> options = firmware_arguments(task);
  // As a lecturer would keep it beside the robot.
  folder.write("robot.hdt", firmware_hdt(options));
  options.insert(options.end(), board.options.begin(), board.options.end());
  std::ranges::replace(options, "NODE", std::to_string(node));
  RunningFirmware firmware(options, folder.path());
  RunningProgram program(
      {task.program, {{"EYEBRIDGE_HAL", firmware.hal() + board.url_options}}, folder.path()});
  const int exit_code = program.wait();
  return {firmware.stop(), exit_code, program.said()};
}

/// A row of the table that docs/parity.md keeps; into a file for whoever collects them.
void report(const Board& board, const Task& task, double length, double off, double turned) {
  char row[200];
  std::snprintf(row, sizeof row, "| %s | %s | %.0f | %.1f | %.2f | %.2f |\n", board.name.c_str(),
                task.name.c_str(), m_to_mm(length), m_to_mm(off),
                length > 0.01 ? 100 * off / length : 0.0, turned);
  std::fputs(row, stdout);
  const char* const table = std::getenv("EYEBRIDGE_TEST_PARITY_TABLE");
  if (table == nullptr) return;
  if (std::FILE* const file = std::fopen(table, "a")) {
    std::fputs(row, file);
    std::fclose(file);
  }
}

class Parity : public ::testing::TestWithParam<Board> {};

TEST_P(Parity, TheRobotEndsWhereTheSimulatedOneDoes) {
  const Board& board = GetParam();
  const std::vector<Task> all = tasks();
  std::vector<std::future<BoardRun>> runs;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i >= board.at_once) runs[i - board.at_once].wait();
    runs.push_back(std::async(std::launch::async, run_on, board, all[i], static_cast<int>(i) + 1));
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    SCOPED_TRACE(all[i].name);
    const Course expected = simulated(all[i]);
    const BoardRun run = runs[i].get();
    EXPECT_EQ(run.exit_code, 0) << run.said;
    EXPECT_THAT(run.said, Not(HasSubstr("eyebridge:"))) << "a missed command, or a warning";
    EXPECT_THAT(run.said, Not(HasSubstr("missed")));
    const double off = norm(run.end.position() - expected.end.position());
    const double turned = rad_to_deg(std::abs(wrap_angle(run.end.theta - expected.end.theta)));
    report(board, all[i], expected.length, off, turned);
    // A turn on the spot has no path; two millimetres are what its wheels' ends round to.
    EXPECT_LE(off, std::max(0.02 * expected.length, 0.002));
    EXPECT_LE(turned, 2.0);
  }
}

std::vector<Board> boards() {
  std::vector<Board> all{
      {"Io7PtyHostVw", {"--no-vw", "--pty", "./eyebot.tty"}, "?hdt=robot.hdt"},
      {"Io7PtyBoardVw",
       {"--verbose", "--prompt", "--pty", "./eyebot.tty"},
       "?hdt=robot.hdt&profile=io7vw"},
      {"Io7PtyBinary", {"--no-vw", "--binary", "--lsb", "--pty", "./eyebot.tty"}, "?hdt=robot.hdt"},
      {"Io7Tcp", {"--no-vw", "--tcp", "0"}, "?hdt=robot.hdt"},
      {"CanSocket", {"--can", "./eyebot.bus", "--node", "NODE"}, ""},
      // An emulated processor is work for a real one.
      {"CortexM3", {"--cortex-m3", "--no-vw", "--pty", "./eyebot.tty"}, "?hdt=robot.hdt", 2},
  };
  // On the lab's kernel: robots of their own, with all numbers, on one bus.
  if (const char* const can = std::getenv("EYEBRIDGE_TEST_CAN")) {
    const std::string name(can);
    all.push_back({"Can_" + name.substr(0, name.find(',')),
                   {"--can", name.substr(0, name.find(',')), "--node", "NODE"},
                   ""});
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Boards, Parity, ::testing::ValuesIn(boards()),
                         [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace eyebridge::testing
