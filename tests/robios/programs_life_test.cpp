// What programs may do to the library while they run.

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "named_program.hpp"

namespace eyebridge {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using testing::kClocks;
using testing::ProgramRun;
using testing::run_named;
using testing::ScratchFolder;

TEST(ProgramLife, AForkedChildLeavesItsParentAlone) {
  const ScratchFolder folder;
  const ProgramRun r = run_named("forks", {{"EYEBRIDGE_OUT", folder.path()}});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out, "child 3\ndriving child 1\nkilled child 143\nshell 4\noutput hello\ndrive 0\n");
  EXPECT_THAT(r.err, HasSubstr("VWStraight: called in a forked process"));
  const std::string trace = testing::file_text(folder.path() + "/trace.csv");
  const auto first_row =
      trace.substr(trace.find('\n'), trace.find(',', trace.find('\n')) - trace.find('\n') + 1);
  EXPECT_EQ(trace.find(first_row), trace.rfind(first_row)) << "rows were written twice";
}

TEST(ProgramLife, AProgramThatItStartsDoesNotWriteItsResults) {
  const std::string program = std::string(EYEBRIDGE_TEST_PROGRAMS) + "/starts_itself";
  for (const bool by_flags : {false, true}) {
    const ScratchFolder folder;
    const std::string out = folder.path() + "/out";
    const std::string record = folder.path() + "/x.ebrec";
    const std::string report = folder.path() + "/report";
    const ProgramRun r =
        by_flags ? testing::run_program({{EYEBRIDGE_BIN "/eyebridge", "run", "--fast", "--out", out,
                                          "--record", record, "--report", report, program},
                                         {},
                                         ""})
                 : run_named("starts_itself", {{"EYEBRIDGE_OUT", out},
                                               {"EYEBRIDGE_RECORD", record},
                                               {"EYEBRIDGE_REPORT", report}});
    EXPECT_EQ(r.exit_code, 0) << r.err;
    EXPECT_EQ(r.err.find("error"), std::string::npos) << r.err;
    // It runs for 1 s, the one that it starts for 0.5 s.
    EXPECT_THAT(testing::file_text(report), ContainsRegex("^time = +1[.]0"));
    EXPECT_THAT(testing::file_text(out + "/trace.csv"), HasSubstr("\n0.960,"));
    EXPECT_TRUE(std::filesystem::exists(record));
  }
}

TEST(ProgramLife, ThreadsOfTheRendererDoNotKeepAProgramAlive) {
  // glibc never destroys the thread_local objects of a main thread that left by pthread_exit, here
  // the renderer: the leak checker would report it.
  const ProgramRun r = run_named("camera_threads", {{"ASAN_OPTIONS", "detect_leaks=0"}});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("frame 0\n"));
}

TEST(ProgramLife, SleepingInLibcFollowsTheRobotsClock) {
  constexpr int kSlept = 3000;  // milliseconds
  for (const auto& clock : kClocks) {
    const ProgramRun r = run_named("sleeps", clock);
    EXPECT_EQ(r.exit_code, 0) << r.err;
    int waited = 0;
    int drove = 0;
    ASSERT_EQ(std::sscanf(r.out.c_str(), "waited %d drove %d", &waited, &drove), 2) << r.out;
    // On a busy computer a thread wakes later than asked for, and the robot drives on meanwhile.
    EXPECT_GE(waited, kSlept);
    if (clock.at("EYEBRIDGE_FAST") == "true") {
      EXPECT_LT(waited, kSlept + 50);
    }
    EXPECT_GT(drove, kSlept / 10 - 20) << "at 100 mm/s, with ramps";
    EXPECT_LE(drove, waited / 10);
  }
}

TEST(ProgramLife, AnExceptionOfATimerEndsTheProgramOnEveryClock) {
  for (std::map<std::string, std::string> settings : testing::kClocks) {
    settings["ASAN_OPTIONS"] = testing::kCrashesAreTheKernels;
    const ProgramRun r = run_named("throws_in_timer", settings);
    EXPECT_EQ(r.exit_code, 128 + SIGABRT) << r.err;
    EXPECT_THAT(r.err, HasSubstr("of a timer"));
    EXPECT_EQ(r.out, "");
  }
}

TEST(ProgramLife, RealTimeTellsHowLateWaitsEnded) {
  const ScratchFolder folder;
  const std::string report = folder.path() + "/report";
  std::map<std::string, std::string> settings = testing::kClocks[1];
  settings["EYEBRIDGE_LOG"] = "info";
  settings["EYEBRIDGE_REPORT"] = report;
  const ProgramRun r = run_named("sleeps", settings);
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.err, ContainsRegex("[0-9]+ waits: 99 of 100 ended at most [0-9.]+ ms too late"));
  EXPECT_THAT(testing::file_text(report),
              ContainsRegex("wait_late_99 = +[0-9.]+\nwait_late_most = "));
  const ProgramRun fast = run_named("sleeps", {{"EYEBRIDGE_LOG", "info"}});
  EXPECT_EQ(fast.err.find("too late"), std::string::npos) << "virtual time is never late";
}

TEST(ProgramLife, NullPointersFailInsteadOfCrashing) {
  const ProgramRun r = run_named("nulls", {{"EYEBRIDGE_KEYS", "KEY1@1s"}});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out, "failed 21 of 21\nleft out 0\n");
}

TEST(ProgramLife, MistakesInALoopAreReportedOnce) {
  const ProgramRun r = run_named("mistakes");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("position 1\nimage 1 1\nspeed 1 1\n"));
  EXPECT_THAT(r.err, HasSubstr("no PSD 9"));
  EXPECT_THAT(r.err, HasSubstr("no PSD 10"));
  EXPECT_LT(std::count(r.err.begin(), r.err.end(), '\n'), 20);
}

}  // namespace
}  // namespace eyebridge
