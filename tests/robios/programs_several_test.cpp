// Several robots that run programs in one process.
#include <filesystem>
#include <map>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "several_robots.hpp"

namespace eyebridge {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::run_named;
using testing::several;
using testing::sorted_lines;
using ::testing::StartsWith;
using testing::trace_of;

TEST(SeveralRobots, EachHasItsOwnVariablesTimeAndNumber) {
  for (const char* program : {"several", "several_by_table"}) {
    const auto r = run_named(program, several("3"));
    EXPECT_EQ(r.exit_code, 0) << r.err;
    EXPECT_THAT(sorted_lines(r.out),
                ElementsAre("1: counted 6 calls 6 mine 3 camera 160 x 10 at 600 alone",
                            "2: counted 7 calls 7 mine 7 camera 320 x 20 at 700 alone",
                            "3: counted 8 calls 8 mine 10 camera 320 x 40 at 800 alone"))
        << r.err;
    EXPECT_THAT(r.err, HasSubstr("eyebridge: 3 robots, "));
  }
}

TEST(SeveralRobots, KeysAndTouchesMayBeOneRobotsAlone) {
  const auto r = run_named(
      "several_keys",
      several("3", {{"EYEBRIDGE_KEYS", "KEY1@1s,2:KEY3@2s,3:120:80@3s,3:KEY4@1500ms,1:9:8@2s"}}));
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(sorted_lines(r.out),
              ElementsAre("1: keys 1 touch 9:8", "2: keys 5 touch -1:-1", "3: keys 9 touch 120:80"))
      << r.err;
}

TEST(SeveralRobots, VariablesAreSharedWhenAskedFor) {
  const auto r = run_named("several", several("3", {{"EYEBRIDGE_SHARED_GLOBALS", "true"}}));
  EXPECT_EQ(r.exit_code, 0) << r.err;
  // 6 + 7 + 8 rounds on one counter; the first robots have ended when the last one has counted all.
  EXPECT_THAT(r.out, HasSubstr("3: counted 21 calls 21 mine "));
}

TEST(SeveralRobots, ProgramsWithThreadsShareNoVariables) {
  const auto r = run_named("several_crew", several("2", {{"EYEBRIDGE_SHARED_GLOBALS", "true"}}));
  EXPECT_EQ(r.exit_code, 2) << r.out;
  EXPECT_THAT(r.err, HasSubstr("several_crew: found a program with threads (it asks the system "));
  EXPECT_THAT(r.err, HasSubstr("), which several robots cannot have in one process, so that they "
                               "cannot share variables; leave out shared_globals, and each has a "
                               "process of its own"));
}

TEST(SeveralRobots, InRealTimeTheyAreTheSame) {
  const auto r = run_named("several", several("3", testing::kClocks[1]));
  EXPECT_EQ(r.exit_code, 0) << r.err;
  // How far each got depends on the computer.
  EXPECT_THAT(sorted_lines(r.out),
              ElementsAre(StartsWith("1: counted 6 calls 6 mine 3 camera 160 x "),
                          StartsWith("2: counted 7 calls 7 mine 7 camera 320 x "),
                          StartsWith("3: counted 8 calls 8 mine 10 camera 320 x ")))
      << r.err;
}

TEST(SeveralRobots, AnEndOfAnyKindIsThatRobotsOwn) {
  for (const auto& clock : testing::kClocks) {
    const auto r = run_named("several_ends", several("8", clock));
    EXPECT_EQ(r.exit_code, 3) << r.err;  // the first robot's
    EXPECT_EQ(r.out, "robot 8 is left\n");
    EXPECT_THAT(r.err,
                AllOf(HasSubstr("robot 1: warning: the program ended with exit code 3\n"),
                      HasSubstr("robot 2: warning: the program ended with exit code 4\n"),
                      HasSubstr("robot 3: error: the program called abort(); it ends, the others "
                                "go on\n"),
                      HasSubstr("robot 4: error: the program was ended by a signal: Floating point "
                                "exception; the others go on\n"),
                      Not(HasSubstr("robot 1: error")), Not(HasSubstr("robot 2: error")),
                      Not(HasSubstr("robot 5: ")), Not(HasSubstr("robot 8: "))));
  }
}

TEST(SeveralRobots, ACrashIsTheRobotsOwnInAProcessOfItsOwn) {
  for (auto clock : testing::kClocks) {
    clock["EYEBRIDGE_ISOLATE"] = "true";
    clock["ASAN_OPTIONS"] = testing::kCrashesAreTheKernels;
    const auto r = run_named("several_ends", several("8", clock));
    EXPECT_EQ(r.exit_code, 3) << r.err;
    EXPECT_EQ(r.out, "robot 8 is left\n");
    const auto ended_by = [](const std::string& robot, const std::string& signal) {
      return HasSubstr("robot " + robot + ": error: the program was ended by a signal: " + signal +
                       "; the others go on\n");
    };
    EXPECT_THAT(r.err,
                AllOf(ended_by("3", "Aborted"), ended_by("4", "Floating point exception"),
                      ended_by("5", "Segmentation fault"), ended_by("6", "Segmentation fault"),
                      ended_by("7", "Segmentation fault"), Not(HasSubstr("robot 8: "))));
  }
}

TEST(SeveralRobots, InProcessesOfTheirOwnTheyDriveTheSameWay) {
  const auto together = run_named("several_follow", several("2"));
  const auto isolated = run_named("several_follow", several("2", {{"EYEBRIDGE_ISOLATE", "true"}}));
  EXPECT_EQ(isolated.exit_code, 0) << isolated.err;
  EXPECT_EQ(isolated.out, together.out);
#if !defined(__SANITIZE_ADDRESS__)  // which looks at the time itself, at the end of a process
  EXPECT_EQ(trace_of(isolated.err), trace_of(together.err));
#endif
}

TEST(SeveralRobots, ProcessesOfTheirOwnShareNoVariables) {
  const auto r = run_named("several", several("2", {{"EYEBRIDGE_ISOLATE", "true"},
                                                    {"EYEBRIDGE_SHARED_GLOBALS", "true"}}));
  EXPECT_NE(r.exit_code, 0);
  EXPECT_THAT(r.err, HasSubstr("isolate: programs in processes of their own cannot share "
                               "variables; leave out isolate or shared_globals"));
}

TEST(SeveralRobots, EachHasTheStreamsOfCpp) {
  const auto expect_own = [](const std::string& program,
                             const std::map<std::string, std::string>& variables) {
    const auto r = run_named(program, variables);
    EXPECT_EQ(r.exit_code, 0) << r.err;
    EXPECT_THAT(
        sorted_lines(r.out),
        ElementsAre("robot 1 counts to 10", "robot 1 reads nothing", "robot 2 counts to 14",
                    "robot 2 reads nothing", "robot 3 counts to 30", "robot 3 reads nothing",
                    "robot 4 counts to 40", "robot 4 reads nothing", "robot 5 counts to 50",
                    "robot 5 reads nothing", "robot 6 counts to 60", "robot 6 reads nothing"));
    EXPECT_THAT(r.err, HasSubstr("eyebridge: 6 robots, "));  // though wide characters came before
    EXPECT_THAT(r.err, AllOf(HasSubstr("robot 1 errs\n"), HasSubstr("robot 3 errs\n"),
                             HasSubstr("robot 1 logs\n"), HasSubstr("robot 3 logs\n")));
  };
  for (const auto& clock : testing::kClocks) expect_own("several_streams", several("6", clock));
  expect_own("several_streams_by_table", several("6"));
}

#if !defined(__SANITIZE_ADDRESS__)  // whose heap is another one
TEST(SeveralRobots, OneMoreTakesLessThan64KilobytesOfHeap) {
  const auto heap = [](const std::string& robots) {
    const auto r = run_named("several_heap", {{"EYEBRIDGE_ROBOTS", robots}});
    EXPECT_EQ(r.exit_code, 0) << r.err;
    return std::stod("0" + r.out);
  };
  const double one = (heap("45") - heap("5")) / 40;
  RecordProperty("heap_bytes_a_robot", static_cast<int>(one));
  EXPECT_GT(one, 4 * 1024.0);
  EXPECT_LE(one, 64 * 1024.0);
}
#endif

TEST(SeveralRobots, ARobotWhoseProgramEndedKeepsItsLastCommand) {
  const auto r = run_named("several_follow", several("2"));
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out, "1 said gone at 1500; went on 200 mm\n") << r.err;
}

TEST(SeveralRobots, ThreadsOfProgramsTakeTurns) {
  const auto r = run_named("several_crew", several("3"));
  EXPECT_EQ(r.exit_code, 0) << r.err;
  // One second of the year 2000 is about 10^9 seconds after 1970: zero billions.
  EXPECT_THAT(sorted_lines(r.out),
              ElementsAre("1: took 5, late after 760 ms, 0", "2: took 5, late after 760 ms, 0",
                          "3: took 5, late after 760 ms, 0"))
      << r.err;
  EXPECT_EQ(trace_of(run_named("several_crew", several("3")).err), trace_of(r.err));
}

TEST(SeveralRobots, ThreadsOfProgramsWorkInRealTime) {
  const auto r = run_named("several_crew", several("3", {{"EYEBRIDGE_FAST", "false"}}));
  EXPECT_EQ(r.exit_code, 0) << r.err;
  for (const char* number : {"1", "2", "3"}) {
    EXPECT_THAT(r.out, HasSubstr(number + std::string(": took 5, late after ")));
  }
}

TEST(SeveralRobots, OneThatHangsIsToldOfAndEnded) {
  const auto r =
      run_named("several_hang",
                several("3", {{"EYEBRIDGE_HANG_LIMIT", "1s"}, {"EYEBRIDGE_ISOLATE", "true"}}));
  EXPECT_EQ(r.exit_code, 124) << r.err;
  EXPECT_EQ(r.out, "1 at 10100\n3 at 10100\n");
  EXPECT_THAT(
      r.err, AllOf(HasSubstr("robot 2: warning: the program has computed for 0.5 s without a call"),
                   HasSubstr("robot 2: error: the program has made no call for too long")));
}

TEST(SeveralRobots, OneWhoseThreadsWaitForEachOtherIsTold) {
  const auto r = run_named("several_stuck", several("2"));
  EXPECT_EQ(r.exit_code, 1);
  EXPECT_EQ(r.out, "robot 2 is done\n");
  EXPECT_THAT(r.err, HasSubstr("robot 1: error: all threads of the program wait for each other"));
}

TEST(SeveralRobots, ResultsGoToAFolderEach) {
  const testing::ScratchFolder folder;
  const auto r = run_named("several", several("2", {{"EYEBRIDGE_OUT", folder.path() + "/out"}}));
  EXPECT_EQ(r.exit_code, 0) << r.err;
  for (const char* number : {"1", "2"}) {
    const std::string out = folder.path() + "/out/robot-" + number;
    EXPECT_EQ(testing::file_text(out + "/lcd.txt").substr(0, 7), std::string("robot ") + number);
    EXPECT_GT(testing::file_text(out + "/trace.csv").size(), 1000U);
  }
}

TEST(SeveralRobots, AResultThatIsNotWholeFailsTheRun) {
  const testing::ScratchFolder folder;
  const auto report = run_named("several", several("2", {{"EYEBRIDGE_REPORT", "/dev/full"}}));
  EXPECT_EQ(report.exit_code, 1);
  EXPECT_THAT(report.err, HasSubstr("the report /dev/full could not be written"));
  std::filesystem::create_directories(folder.path() + "/robot-2");
  std::filesystem::create_symlink("/dev/full", folder.path() + "/robot-2/trace.csv");
  const auto out = run_named("several", several("2", {{"EYEBRIDGE_OUT", folder.path()}}));
  EXPECT_EQ(out.exit_code, 1);
  EXPECT_THAT(out.err, HasSubstr("robot 2: error: " + folder.path() + "/robot-2/trace.csv"));
}

TEST(SeveralRobots, WhatOnlyOneCanHaveIsRefused) {
  const auto recorded = run_named("several", several("2", {{"EYEBRIDGE_RECORD", "/tmp/x.ebrec"}}));
  EXPECT_EQ(recorded.exit_code, 2);
  EXPECT_THAT(recorded.err, HasSubstr("EYEBRIDGE_RECORD: found --record for 2 robots"));
  const auto none = run_named("several", several("0"));
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.err,
              HasSubstr("EYEBRIDGE_ROBOTS: found '0', expected 1 … 100000 robots, or all"));
  const auto many = run_named("several", several("9999"));
  EXPECT_EQ(many.exit_code, 2);
  EXPECT_THAT(many.err, HasSubstr("this world has room for"));
}

}  // namespace
}  // namespace eyebridge
