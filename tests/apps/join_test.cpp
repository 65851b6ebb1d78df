// `eyebridge add` and `remove` in a run that began with one robot.
#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "changing_run.hpp"
#include "command.hpp"
#include "running_program.hpp"

namespace eyebridge {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing::RunningProgram;

/// Programs for a room of 3 x 3 m.
class Join : public testing::ChangingRun {
 protected:
  Join() {
    sim_ = folder_.write("room.sim", "world room.wld\nS4 500 500 0\nS4 500 2500 0\n");
    // Waits for a word by radio, drives, and ends with the exit code that it is given. A second
    // argument makes it compute first, which takes no virtual time: a robot can be added before a
    // time limit is over.
    folder_.write("waits.c",
                  "#include <eyebot.h>\n#include <stdio.h>\n#include <stdlib.h>\n"
                  "int main(int argc, char** argv) {\n"
                  "  char text[20] = \"\"; int id = 0;\n"
                  "  RADIOInit();\n  printf(\"ready %d\\n\", OSMachineID()); fflush(stdout);\n"
                  "  for (volatile long i = 0; argc > 2 && i < 2000000000; ++i) {}\n"
                  "  while (RADIOCheck() <= 0) OSWait(20);\n"
                  "  RADIOReceive(&id, text, sizeof text);\n"
                  "  printf(\"%s from %d\\n\", text, id); fflush(stdout);\n"
                  "  VWSetSpeed(100, 0);\n  return argc > 1 ? atoi(argv[1]) : 0;\n}\n");
    // Says a word to robot 1, and 2 s later how far that has come.
    folder_.write("says.c",
                  "#include <eyebot.h>\n#include <stdio.h>\nint main(int argc, char** argv) {\n"
                  "  int x = 0, y = 0, z = 0, phi = 0;\n  RADIOInit();\n"
                  "  RADIOSend(1, argc > 1 ? argv[1] : \"nothing\");\n  OSWait(2000);\n"
                  "  SIMGetRobot(1, &x, &y, &z, &phi);\n"
                  "  printf(\"robot 1 %s\\n\", x > 600 ? \"went on\" : \"stands\");\n"
                  "  return 5;\n}\n");
    folder_.write("turns.c",
                  "#include <eyebot.h>\n#include <stdio.h>\nint main(void) {\n"
                  "  VWSetSpeed(0, 90);\n  LCDPrintf(\"going\");\n"
                  "  puts(\"turns\"); fflush(stdout);\n  for (;;) OSWait(10);\n}\n");
    build("waits says turns");
  }
  [[nodiscard]] testing::ProgramStart start(const std::vector<std::string>& program,
                                            const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{EYEBRIDGE_BIN "/eyebridge", "run", GetParam(), "--world", sim_};
    words.insert(words.end(), more.begin(), more.end());
    words.insert(words.end(), program.begin(), program.end());
    return {words, own_place(), folder_.path()};
  }
};

TEST_P(Join, ARobotJoinsOneThatBeganAlone) {
  RunningProgram run(start({"waits"}));
  run.wait_for("ready 1\n");
  const auto standing = ask({"add", "labbot", "1000", "2000", "0"});
  EXPECT_EQ(standing.out, "3\n") << standing.err;
  EXPECT_THAT(error({"add", "S4", "510", "2500", "0"}), HasSubstr("would stand in robot 2"));
  const auto saying = ask({"add", "S4", "500", "1500", "90", "says", "hello"});
  EXPECT_EQ(saying.out, "4\n") << saying.err;
  EXPECT_EQ(run.wait(), 5) << run.said();
  EXPECT_THAT(run.said(), HasSubstr("hello from 4\n"));
  EXPECT_THAT(run.said(), HasSubstr("robot 1 went on\n")) << "after its program's end";
  EXPECT_THAT(run.said(), HasSubstr("robot 4: warning: the program ended with exit code 5"));
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path() + "/eyebridge"));
}

TEST_P(Join, TheFirstRobotsExitCodeComesFirst) {
  RunningProgram run(start({"waits", "3"}, {"--robots", "1"}));
  run.wait_for("ready 1\n");
  EXPECT_EQ(ask({"add", "S4", "500", "1500", "90", "says", "end"}).out, "3\n");
  EXPECT_EQ(run.wait(), 3) << run.said();
  EXPECT_THAT(run.said(), HasSubstr("robot 1 went on\n"));
}

TEST_P(Join, AProgramThatIsRunDirectlyLetsRobotsIn) {
  auto direct = start({"waits"});
  direct.command = {"./waits"};
  direct.environment["EYEBRIDGE_WORLD"] = sim_;
  direct.environment[std::string(GetParam()) == "--fast" ? "EYEBRIDGE_FAST" : "EYEBRIDGE_FACTOR"] =
      std::string(GetParam()) == "--fast" ? "true" : "20";
  RunningProgram run(direct);
  run.wait_for("ready 1\n");
  EXPECT_EQ(ask({"add", "S4", "500", "1500", "90", "says", "hi"}).out, "3\n");
  EXPECT_EQ(run.wait(), 5) << run.said();
  EXPECT_THAT(run.said(), HasSubstr("hi from 3\n"));
}

TEST_P(Join, RobotsLeaveAgainButNotTheFirst) {
  RunningProgram run(start({"waits"}, {"--out", "out"}));
  run.wait_for("ready 1\n");
  EXPECT_EQ(ask({"add", "S4", "1500", "1500", "0", "turns"}).out, "3\n");
  run.wait_for("turns\n");
  EXPECT_THAT(error({"remove", "1"}), HasSubstr("robot 1 cannot be removed: the world of this run "
                                                "is in its program's process. End that program"));
  EXPECT_EQ(error({"remove", "7"}), "eyebridge: no robot 7, the world has 3\n");
  const auto removed = ask({"remove", "3"});
  EXPECT_EQ(removed.out, "3\n") << removed.err;
  EXPECT_THAT(testing::file_text(folder_.path() + "/out/robot-3/lcd.txt"), HasSubstr("going"));
  EXPECT_EQ(error({"remove", "3"}), "eyebridge: robot 3 has been removed\n");
  EXPECT_EQ(ask({"remove", "2"}).out, "2\n") << "it has no program";
  EXPECT_EQ(ask({"add", "S4", "1500", "1500", "0", "says", "end"}).out, "4\n");
  EXPECT_EQ(run.wait(), 5) << run.said();
  EXPECT_THAT(run.said(), Not(HasSubstr("robot 3: warning")));
}

TEST_P(Join, CtrlCEndsAllAndResultsAreWritten) {
  RunningProgram run(start({"waits"}, {"--out", "out", "--report", "report.txt"}));
  run.wait_for("ready 1\n");
  EXPECT_EQ(ask({"add", "S4", "1500", "1500", "0", "turns"}).out, "3\n");
  run.wait_for("turns\n");
  EXPECT_EQ(run.finish(SIGINT), 128 + SIGINT) << run.said();
  EXPECT_TRUE(std::filesystem::exists(folder_.path() + "/out/trace.csv"));
  EXPECT_TRUE(std::filesystem::exists(folder_.path() + "/out/robot-3/trace.csv"));
  EXPECT_THAT(testing::file_text(folder_.path() + "/report.txt"), HasSubstr("ended = true"));
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path() + "/eyebridge"));
}

TEST_P(Join, CtrlCEndsThoseWhoGoOnWithoutTheFirst) {
  RunningProgram run(start({"waits"}));
  run.wait_for("ready 1\n");
  EXPECT_EQ(ask({"add", "S4", "1500", "1500", "0", "turns"}).out, "3\n");
  run.wait_for("turns\n");
  EXPECT_EQ(ask({"add", "S4", "1500", "2500", "0", "says", "end"}).out, "4\n");
  run.wait_for("robot 1 went on\n");
  EXPECT_EQ(run.finish(SIGINT), 128 + SIGINT) << run.said();
}

TEST_P(Join, TheTimeLimitIsThatOfAll) {
  RunningProgram run(start({"waits", "0", "computes"}, {"--time-limit", "60s"}));
  run.wait_for("ready 1\n");
  EXPECT_EQ(ask({"add", "S4", "1500", "1500", "0", "turns"}).out, "3\n");
  EXPECT_EQ(run.wait(), 0) << run.said();
}

TEST_P(Join, WhereOnlyOneCanBeItSaysWhy) {
  RunningProgram run(start({"waits"}, {"--record", "run.ebrec"}));
  run.wait_for("ready 1\n");
  EXPECT_THAT(error({"add", "S4", "1500", "1500", "0"}),
              HasSubstr("found --record, which only a robot that is alone can have; no robot can "
                        "be added to this run: start it without"));
  run.finish(SIGTERM);
}

INSTANTIATE_TEST_SUITE_P(Clocks, Join, ::testing::Values("--fast", "--factor=20"),
                         [](const auto& clock) {
                           return std::string(clock.index == 0 ? "Virtual" : "Real");
                         });

}  // namespace
}  // namespace eyebridge
