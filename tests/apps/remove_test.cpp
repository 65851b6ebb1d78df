// `eyebridge remove`: a robot leaves a run that is under way.
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
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

/// Robot 1 looks at robot 2, which drives round and round; robot 3 stands in a corner.
class Remove : public testing::ChangingRun {
 protected:
  Remove() {
    sim_ = folder_.write(
        "room.sim", "world room.wld\nS4 500 500 0 looks\nS4 2000 500 0 turns\nS4 2500 2500 0\n");
    // Says what is ahead when that changes, and ends when a radio says so.
    folder_.write("looks.c",
                  "#include <eyebot.h>\n#include <stdio.h>\nint main(void) {\n"
                  "  char text[20] = \"\"; int id = 0, far = 0, heard = 0;\n  RADIOInit();\n"
                  "  while (text[0] != 'e') {\n    int ids[10];\n"
                  "    const int is_far = PSDGet(PSD_FRONT) > 2000, count = RADIOStatus(ids);\n"
                  "    if (!heard && count == 2) { puts(\"hears 2\"); heard = 1; }\n"
                  "    if (is_far && !far && heard) printf(\"far, hears %d\\n\", count);\n"
                  "    if (heard) far = is_far;\n    fflush(stdout);\n"
                  "    if (RADIOCheck() > 0) RADIOReceive(&id, text, sizeof text);\n"
                  "    OSWait(20);\n  }\n  return 0;\n}\n");
    folder_.write("turns.c",
                  "#include <eyebot.h>\nint main(void) {\n  RADIOInit();\n"
                  "  VWSetSpeed(0, 90);\n  LCDPrintf(\"going\");\n"
                  "  for (;;) OSWait(10);\n}\n");
    folder_.write("says.c",
                  "#include <eyebot.h>\nint main(void) {\n  RADIOInit();\n"
                  "  return RADIOSend(1, \"end\");\n}\n");
    build("looks turns says");
  }
  [[nodiscard]] testing::ProgramStart start() const {
    return {{EYEBRIDGE_BIN "/eyebridge", "run", GetParam(), "--world", sim_, "--out", "out",
             "--log", "info"},
            own_place(),
            folder_.path()};
  }
  [[nodiscard]] std::string result(const char* name) const {
    return testing::file_text(folder_.path() + "/out/" + name);
  }
};

TEST_P(Remove, EndsAProgramAndTakesItsRobotOutOfTheWorld) {
  RunningProgram run(start());
  run.wait_for("hears 2\n");
  const auto removed = ask({"remove", "2"});
  EXPECT_EQ(removed.out, "2\n") << removed.err;
  EXPECT_EQ(removed.exit_code, 0);
  // No rays end at it, and its radio is silent.
  EXPECT_THAT(run.wait_for("far, hears"), HasSubstr("far, hears"));
  EXPECT_THAT(run.wait_for("\n"), HasSubstr("far, hears 1\n"));
  EXPECT_THAT(result("robot-2/lcd.txt"), HasSubstr("going"));
  EXPECT_NE(result("robot-2/trace.csv"), "");
  // The others keep their numbers; its own is not used again, its place is.
  EXPECT_EQ(ask({"add", "S4", "2000", "500", "0", "says"}).out, "4\n");
  EXPECT_EQ(run.wait(), 0) << run.said();
  EXPECT_THAT(run.said(), HasSubstr("eyebridge: 3 robots, "));
  EXPECT_THAT(run.said(), HasSubstr("robot 2 is removed"));
}

TEST_P(Remove, ARobotWithoutAProgramLeavesToo) {
  RunningProgram run(start());
  run.wait_for("hears 2\n");
  EXPECT_THAT(error({"add", "S4", "2500", "2500", "0"}), HasSubstr("would stand in robot 3"));
  EXPECT_EQ(ask({"remove", "3"}).out, "3\n");
  EXPECT_EQ(ask({"add", "S4", "2500", "2500", "0"}).out, "4\n");
  EXPECT_EQ(run.finish(SIGTERM), 128 + SIGTERM) << run.said();
}

TEST_P(Remove, WhoIsNotThereIsRefusedAndTheRunGoesOn) {
  RunningProgram run(start());
  run.wait_for("hears 2\n");
  EXPECT_EQ(error({"remove", "4"}), "eyebridge: no robot 4, the world has 3\n");
  EXPECT_THAT(error({"remove", "0"}), HasSubstr("found '0', expected the number of a robot"));
  EXPECT_THAT(error({"remove", "two"}), HasSubstr("found 'two', expected the number of a robot"));
  EXPECT_THAT(error({"remove"}), HasSubstr("NUMBER is required"));
  EXPECT_EQ(ask({"remove", "2"}).out, "2\n");
  EXPECT_EQ(error({"remove", "2"}), "eyebridge: robot 2 has been removed\n");
  EXPECT_EQ(ask({"add", "S4", "1000", "1500", "0", "says"}).out, "4\n");
  EXPECT_EQ(run.wait(), 0) << run.said();
}

TEST_P(Remove, ARunWhoseLastProgramIsRemovedEnds) {
  RunningProgram run(start());
  run.wait_for("hears 2\n");
  EXPECT_EQ(ask({"remove", "1"}).out, "1\n");
  EXPECT_EQ(ask({"remove", "2"}).out, "2\n");
  EXPECT_EQ(run.wait(), 0) << run.said();
  EXPECT_THAT(error({"remove", "3"}), HasSubstr("remove: found no run in a simulated world"));
}

// Python knows no sanitizer; its processes under ASan are in tests/python.
#if !defined(__SANITIZE_ADDRESS__)
TEST_P(Remove, EndsAProgramInAProcessOfItsOwn) {
  folder_.write("turns.py",
                "import time\nfrom eye import *\nRADIOInit()\nVWSetSpeed(0, 90)\n"
                "LCDPrintf('going')\nwhile True:\n    OSWait(10)\n");
  sim_ = folder_.write("room.sim", "world room.wld\nS4 500 500 0 looks\nS4 2000 500 0 turns.py\n");
  RunningProgram run(start());
  run.wait_for("hears 2\n");
  const auto removed = ask({"remove", "2"});
  EXPECT_EQ(removed.out, "2\n") << removed.err;
  EXPECT_THAT(run.wait_for("far, hears"), HasSubstr("far, hears"));
  EXPECT_THAT(run.wait_for("\n"), HasSubstr("far, hears 1\n"));
  EXPECT_THAT(result("robot-2/lcd.txt"), HasSubstr("going"));
  EXPECT_EQ(ask({"add", "S4", "1000", "1500", "0", "says"}).out, "3\n");
  EXPECT_EQ(run.wait(), 0) << run.said();
  EXPECT_THAT(run.said(), Not(HasSubstr("Traceback")));
}
#endif

/// The processes that it has started and not yet waited for.
std::ptrdiff_t children_of(pid_t process) {
  std::ptrdiff_t count = 0;
  for (const auto& task :
       std::filesystem::directory_iterator("/proc/" + std::to_string(process) + "/task")) {
    std::ifstream children(task.path() / "children");
    count += std::distance(std::istream_iterator<pid_t>(children), {});
  }
  return count;
}

// Some were started after they had been removed, and ran on as robots that were not there.
TEST_P(Remove, AsSoonAsItCameLeavesNoProcess) {
  auto words = start();
  words.command.insert(words.command.begin() + 2, "--isolate");
  RunningProgram run(words);
  run.wait_for("hears 2\n");
  // In virtual time it is given half a second to write its results.
  const int robots = GetParam() == std::string("--fast") ? 3 : 30;
  for (int number = 4; number < 4 + robots; ++number) {
    // Four at once, so that one of them comes in the moment in which it is started.
    const std::string remove = "until " EYEBRIDGE_BIN "/eyebridge remove " +
                               std::to_string(number) +
                               " 2>&1 | grep -q -e '^[0-9]' -e 'has been removed'; do :; done";
    std::vector<std::unique_ptr<RunningProgram>> removing;
    for (int i = 0; i < 4; ++i) {
      removing.push_back(std::make_unique<RunningProgram>(
          testing::ProgramStart{{"sh", "-c", remove}, own_place(), folder_.path()}));
    }
    ASSERT_EQ(ask({"add", "S4", "1000", "1500", "0", "turns"}).exit_code, 0);
    for (auto& each : removing) ASSERT_EQ(each->wait(), 0) << each->said();
  }
  EXPECT_EQ(children_of(run.pid()), 2) << "of the two programs of the world";
  EXPECT_EQ(run.finish(SIGTERM), 128 + SIGTERM) << run.said();
}

INSTANTIATE_TEST_SUITE_P(Clocks, Remove, ::testing::Values("--fast", "--factor=5"),
                         [](const auto& clock) {
                           return std::string(clock.index == 0 ? "Virtual" : "Real");
                         });

}  // namespace
}  // namespace eyebridge
