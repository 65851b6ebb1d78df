// `eyebridge add`: one more robot for a run that is under way.
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
using testing::RunningProgram;

/// A robot that waits for a word, in a room, and a program that says one.
class Add : public testing::ChangingRun {
 protected:
  Add() {
    sim_ = folder_.write("room.sim", "world room.wld\nS4 500 500 0 waits\nS4 2000 500 0\n");
    folder_.write("waits.c",
                  "#include <eyebot.h>\n#include <stdio.h>\nint main(void) {\n"
                  "  char text[20] = \"\"; int id = 0;\n"
                  "  RADIOInit();\n  puts(\"ready\"); fflush(stdout);\n"
                  "  while (RADIOCheck() <= 0) OSWait(100);\n"
                  "  RADIOReceive(&id, text, sizeof text);\n"
                  "  printf(\"%s from %d\\n\", text, id);\n  return 0;\n}\n");
    folder_.write("says.c",
                  "#include <eyebot.h>\nint main(int argc, char** argv) {\n"
                  "  RADIOInit();\n  return RADIOSend(1, argc > 1 ? argv[1] : \"nothing\");\n}\n");
    build("waits says");
  }
  [[nodiscard]] testing::ProgramStart start() const {
    return {{EYEBRIDGE_BIN "/eyebridge", "run", GetParam(), "--world", sim_},
            own_place(),
            folder_.path()};
  }
  [[nodiscard]] testing::ProgramRun add(std::vector<std::string> words) const {
    words.insert(words.begin(), "add");
    return ask(words);
  }
  [[nodiscard]] std::string error(std::vector<std::string> words) const {
    words.insert(words.begin(), "add");
    return ChangingRun::error(words);
  }
};

TEST_P(Add, LetsARobotInAndTellsItsNumber) {
  RunningProgram run(start());
  run.wait_for("ready\n");
  const auto standing = add({"labbot", "1000", "2000", "0"});
  EXPECT_EQ(standing.out, "3\n") << standing.err;
  const auto saying =
      add({"--run", std::to_string(run.pid()), "S4", "500", "1000", "90", "says", "--fast"});
  EXPECT_EQ(saying.out, "4\n") << saying.err;
  EXPECT_EQ(saying.exit_code, 0);
  EXPECT_EQ(run.wait(), 0) << run.said();
  EXPECT_THAT(run.said(), HasSubstr("--fast from 4\n"));
  EXPECT_THAT(run.said(), HasSubstr("eyebridge: 2 robots, "));
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path() + "/eyebridge"));
}

TEST_P(Add, WhatCannotBeIsRefusedAndTheRunGoesOn) {
  RunningProgram run(start());
  run.wait_for("ready\n");
  EXPECT_EQ(error({"S4", "2100", "500", "0"}),
            "eyebridge: S4 (186 mm across) at (2100, 500) mm would stand in robot 2: expected a "
            "free place\n");
  EXPECT_THAT(error({"S4", "50", "1000", "0"}), HasSubstr("would stand in a wall: expected"));
  EXPECT_THAT(error({"S5", "1000", "1000", "0"}), HasSubstr("no robot 'S5': expected"));
  EXPECT_THAT(error({"my.robi", "1000", "1000", "0"}), HasSubstr("my.robi: "));
  EXPECT_THAT(error({"S4", "1000", "far", "0"}), HasSubstr("y: found 'far', expected a number"));
  EXPECT_THAT(error({"S4", "1000", "2e7", "0"}),
              HasSubstr("y: found '2e7', expected a number -10000000 ... 10000000"));
  EXPECT_THAT(error({"S4", "1000", "1000", "0", "says", std::string(70'000, 'x')}),
              HasSubstr("expected at most 65536 bytes"));
  EXPECT_THAT(error({"S4", "1000", "1000"}), HasSubstr("expected eyebridge add [--run PID] MODEL"));
  EXPECT_THAT(error({"S4", "1000", "1000", "0", "nowhere"}), HasSubstr("nowhere: no such program"));
  EXPECT_THAT(error({"--run", "1", "S4", "1000", "1000", "0"}),
              HasSubstr("--run: found 1, expected the process of a run in a simulated world"));
  EXPECT_EQ(add({"S4", "1000", "1000", "0", "says"}).out, "3\n");
  EXPECT_EQ(run.wait(), 0) << run.said();
}

TEST_P(Add, WithoutARunOrWithSeveralItSaysSo) {
  EXPECT_THAT(error({"S4", "1000", "1000", "0"}),
              HasSubstr("add: found no run in a simulated world"));
  RunningProgram first(start());
  RunningProgram second(start());
  first.wait_for("ready\n");
  second.wait_for("ready\n");
  EXPECT_THAT(error({"S4", "1000", "1000", "0"}),
              HasSubstr("add: found 2 runs, expected one: --run "));
  EXPECT_EQ(second.finish(SIGKILL), 128 + SIGKILL);  // leaves its control socket behind
  EXPECT_EQ(add({"S4", "1000", "1000", "0"}).out, "3\n");
  first.finish(SIGTERM);
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path() + "/eyebridge"));
}

TEST_P(Add, ARunThatNobodyCanFindSaysSo) {
  testing::ProgramStart hidden = start();
  folder_.write("taken", "a file, no folder");
  hidden.environment["XDG_RUNTIME_DIR"] = folder_.path() + "/taken";
  hidden.environment["EYEBRIDGE_LOG"] = "info";
  RunningProgram run(hidden);
  run.wait_for("ready\n");
  run.finish(SIGTERM);
  EXPECT_THAT(run.said(), HasSubstr("no robot can be added: expected $XDG_RUNTIME_DIR/eyebridge"));
}

INSTANTIATE_TEST_SUITE_P(Clocks, Add, ::testing::Values("--fast", "--factor=20"),
                         [](const auto& clock) {
                           return std::string(clock.index == 0 ? "Virtual" : "Real");
                         });

}  // namespace
}  // namespace eyebridge
