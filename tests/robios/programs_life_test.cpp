// How programs end, whatever way, and what they may do to the library meanwhile.

#include <algorithm>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "named_program.hpp"

namespace eyebridge {
namespace {

using ::testing::HasSubstr;
using testing::ProgramRun;
using testing::run_named;
using testing::ScratchFolder;

/// Both clocks; the settings of a real-time run that does not keep a person waiting.
const std::map<std::string, std::string> kClocks[] = {
    {{"EYEBRIDGE_FAST", "true"}}, {{"EYEBRIDGE_FAST", "false"}, {"EYEBRIDGE_FACTOR", "20"}}};

void expect_results(const ScratchFolder& folder) {
  for (const char* name : {"map.png", "lcd.png", "trace.csv"}) {
    EXPECT_GT(std::filesystem::file_size(folder.path() + "/" + name), 100U) << name;
  }
}

ProgramRun end_by(const std::string& how, std::map<std::string, std::string> settings,
                  const ScratchFolder& folder) {
  settings["EYEBRIDGE_TEST_HOW"] = how;
  settings["EYEBRIDGE_OUT"] = folder.path();
  return run_named("ends", settings);
}

TEST(ProgramLife, ResultsAreWrittenHoweverAProgramEnds) {
  const std::map<std::string, int> ways = {{"return", 5}, {"timer", 7}, {"signal", 128 + 15}};
  for (const auto& clock : kClocks) {
    for (const auto& [how, code] : ways) {
      const ScratchFolder folder;
      const ProgramRun r = end_by(how, clock, folder);
      EXPECT_EQ(r.exit_code, code) << how << r.err;
      expect_results(folder);
    }
  }
}

TEST(ProgramLife, ATraceThatCannotBeWrittenDoesNotStopTheProgram) {
  const ScratchFolder folder;
  std::filesystem::create_symlink("/dev/full", folder.path() + "/trace.csv");
  const ProgramRun r = run_named("endless", {{"EYEBRIDGE_FAST", "true"},
                                             {"EYEBRIDGE_TIME_LIMIT", "30s"},
                                             {"EYEBRIDGE_OUT", folder.path()}});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.err, HasSubstr("trace.csv"));
  EXPECT_THAT(r.err, HasSubstr("No space left on device"));
}

TEST(ProgramLife, ATimeLimitEndsThreadsThatPollAndMainsThatSleep) {
  for (const auto& clock : kClocks) {
    for (const char* how : {"wait", "idle"}) {
      const ScratchFolder folder;
      auto settings = clock;
      settings["EYEBRIDGE_TIME_LIMIT"] = "1s";
      EXPECT_EQ(end_by(how, settings, folder).exit_code, 0) << how;
      expect_results(folder);
    }
  }
}

TEST(ProgramLife, CallsAfterTheEndMoveNothing) {
  const ScratchFolder folder;
  EXPECT_THAT(end_by("return", {}, folder).out, HasSubstr("late call 1\n"));
}

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

TEST(ProgramLife, ThreadsOfTheRendererDoNotKeepAProgramAlive) {
  // glibc never destroys the thread_local objects of a main thread that left by pthread_exit, here
  // the renderer: the leak checker would report it.
  const ProgramRun r = run_named("camera_threads", {{"ASAN_OPTIONS", "detect_leaks=0"}});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("frame 0\n"));
}

TEST(ProgramLife, SleepingInLibcFollowsTheRobotsClock) {
  for (const auto& clock : kClocks) {
    const ProgramRun r = run_named("sleeps", clock);
    EXPECT_EQ(r.exit_code, 0) << r.err;
    EXPECT_THAT(r.out, HasSubstr("drove 300\n"));
  }
  EXPECT_THAT(run_named("sleeps").out, HasSubstr("waited 3000\n"));
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
  EXPECT_THAT(r.err, HasSubstr("no PSD 5"));
  EXPECT_THAT(r.err, HasSubstr("no PSD 6"));
  EXPECT_LT(std::count(r.err.begin(), r.err.end(), '\n'), 20);
}

}  // namespace
}  // namespace eyebridge
