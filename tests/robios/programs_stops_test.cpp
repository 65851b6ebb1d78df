// Robots that crash, hang, wait for ever, or compute on: what becomes of the others.
#include <array>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include "named_program.hpp"

namespace eyebridge {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::ProgramRun;

using Settings = std::map<std::string, std::string>;

std::string program() { return std::string(EYEBRIDGE_TEST_PROGRAMS) + "/several_stops"; }

/// Three robots, of which the second stops in this way.
ProgramRun run_stopping(const std::string& how, Settings settings) {
  settings.emplace("EYEBRIDGE_FAST", "true");
  settings.emplace("EYEBRIDGE_ROBOTS", "3");
  settings.emplace("EYEBRIDGE_HANG_LIMIT", "1s");
  return testing::run_program({{program(), how}, settings, ""});
}

const auto kOthersAreDone =
    AllOf(HasSubstr("1 is at the end\n"), HasSubstr("3 is at the end\n"), Not(HasSubstr("2 is")));

// The others need what a program had locked, or overwrote, when it crashed or hung.
TEST(RobotsThatStop, ACrashEndsTheRunAndTheResultsAreWritten) {
  // The string at 0x8: strlen() of arm64 reads from 0x0 on, where its 16 bytes begin.
  const Settings crashes = {
      {"writes where nothing is", "crashed: Segmentation fault at address 0x8"},
      {"uses up its stack", "crashed: Segmentation fault at address 0x"},
      {"shows no picture", "crashed inside a RoBIOS call: Segmentation fault at address 0x"},
      {"prints nothing", "crashed: Segmentation fault at address 0x"}};
  for (const auto& clock : testing::kClocks) {
    for (const auto& [how, what] : crashes) {
      const testing::ScratchFolder folder;
      Settings settings = clock;
      settings["EYEBRIDGE_OUT"] = folder.path() + "/out";
      const ProgramRun r = run_stopping(how, settings);
      EXPECT_EQ(r.exit_code, 139) << how << r.err;
      EXPECT_THAT(r.err, AllOf(HasSubstr("robot 2: error: the program " + what),
                               HasSubstr("; all robots end (with --isolate only this one would)\n"),
                               HasSubstr("error: the run is ended; results are ")))
          << how;
      if (clock.at("EYEBRIDGE_FAST") == "true") {
        EXPECT_THAT(r.out, Not(HasSubstr("is at the end"))) << how;
      }
      EXPECT_GT(std::filesystem::file_size(folder.path() + "/out/robot-1/trace.csv"), 100U);
    }
  }
}

// With the address sanitizer it ends the process itself.
#if !defined(__SANITIZE_ADDRESS__)
TEST(RobotsThatStop, AHeapThatIsSpoiltEndsTheRunWithAMessage) {
  for (const auto& clock : testing::kClocks) {
    const ProgramRun r = run_stopping("spoils its heap", clock);
    EXPECT_EQ(r.exit_code, 134) << r.err;
    EXPECT_THAT(r.err, AllOf(HasSubstr("robot 2: error: the program crashed: Aborted; all robots "
                                       "end (with --isolate only this one would)\n"),
                             HasSubstr("error: the run is ended; ")));
  }
}
#endif

TEST(RobotsThatStop, AHangIsToldOfAndEndsTheRun) {
  const Settings hangs = {{"computes", "computed for 0.5 s without a call"},
                          {"takes memory", "computed for 0.5 s without a call"},
                          {"reads", "waited for 0.5 s in read()"},
                          {"pauses", "waited for 0.5 s in pause()"}};
  for (const auto& [how, what] : hangs) {
    // ASan asks for the time before it gives memory back to the system: a call, which lets time
    // pass.
    const ProgramRun r =
        run_stopping(how, {{"ASAN_OPTIONS", "allocator_release_to_os_interval_ms=-1"}});
    EXPECT_EQ(r.exit_code, 124) << how << r.err;
    EXPECT_THAT(r.err, AllOf(HasSubstr("robot 2: warning: the program has " + what),
                             HasSubstr("robot 2: error: the program has made no call for too long"),
                             HasSubstr("all robots end (with --isolate only this one would)"),
                             HasSubstr("error: the run is ended; ")));
  }
}

TEST(RobotsThatStop, InProcessesOfTheirOwnTheOthersGoOn) {
  for (const auto& [how, code] : std::map<std::string, int>{{"prints nothing", 139},
                                                            {"shows no picture", 139},
                                                            {"prints", 124},
                                                            {"computes", 124}}) {
    const ProgramRun r = run_stopping(
        how, {{"EYEBRIDGE_ISOLATE", "true"}, {"ASAN_OPTIONS", testing::kCrashesAreTheKernels}});
    EXPECT_EQ(r.exit_code, code) << how << r.err;
    EXPECT_THAT(r.out, kOthersAreDone) << how;
    EXPECT_THAT(r.err, HasSubstr("robot 2: error: ")) << how;
  }
}

TEST(RobotsThatStop, InRealTimeOneThatComputesOnIsToldOfAndEndsWithTheTimeLimit) {
  const ProgramRun r = run_stopping("computes", {{"EYEBRIDGE_FAST", "false"},
                                                 {"EYEBRIDGE_FACTOR", "20"},
                                                 {"EYEBRIDGE_HANG_LIMIT", "0.4s"},
                                                 {"EYEBRIDGE_TIME_LIMIT", "60s"}});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, kOthersAreDone);
  EXPECT_THAT(
      r.err,
      AllOf(HasSubstr("robot 2: warning: the program has computed for 0.2 s without a call"),
            HasSubstr("robot 2: warning: the program has made no call since the time limit was "
                      "reached; it ends")));
}

// Each yield is a microsecond of virtual time. A robot alone needs more processor time for its time
// limit of 3 s than the hang limit of 1 s allows a robot that hangs.
TEST(RobotsThatStop, ALoopThatOnlyYieldsEndsWithTheTimeLimit) {
  for (const auto& [robots, limit] : Settings{{"2", "500ms"}, {"1", "3s"}}) {
    const ProgramRun r = testing::run_named("several_yields", {{"EYEBRIDGE_FAST", "true"},
                                                               {"EYEBRIDGE_ROBOTS", robots},
                                                               {"EYEBRIDGE_HANG_LIMIT", "1s"},
                                                               {"EYEBRIDGE_TIME_LIMIT", limit}});
    EXPECT_EQ(r.exit_code, 0) << r.err;
  }
}

// The limit is so short that who is to be ended is when it is told of.
TEST(RobotsThatStop, OneThatReadsFromATerminalIsOnlyToldOf) {
  int person = -1;
  const pid_t pid = forkpty(&person, nullptr, nullptr, nullptr);
  ASSERT_GE(pid, 0);
  if (pid == 0) {
    setenv("EYEBRIDGE_FAST", "true", 1);
    setenv("EYEBRIDGE_ROBOTS", "3", 1);
    setenv("EYEBRIDGE_HANG_LIMIT", "0.1s", 1);
    setenv("EYEBRIDGE_PANEL", "none", 1);
    execl(program().c_str(), program().c_str(), "asks", nullptr);
    _exit(127);
  }
  std::string said;
  std::array<char, 4096> some{};
  bool has_answered = false;
  for (ssize_t n = 0; (n = read(person, some.data(), some.size())) > 0;) {
    said.append(some.data(), static_cast<std::size_t>(n));
    if (has_answered || said.find("all robots wait for it") == std::string::npos) continue;
    ASSERT_EQ(write(person, "y\n", 2), 2);
    has_answered = true;
  }
  int status = 0;
  ASSERT_EQ(waitpid(pid, &status, 0), pid);
  close(person);
  EXPECT_EQ(WEXITSTATUS(status), 0) << said;
  EXPECT_THAT(said, AllOf(HasSubstr("robot 2: warning: the program has waited for 0.05 s in read() "
                                    "at the terminal; all robots wait for it"),
                          HasSubstr("2 read y"), HasSubstr("2 is at the end")));
}

// No computer makes five million steps in a millisecond.
TEST(RobotsThatStop, ARobotThatIsAloneIsToldOfAComputerThatIsTooSlow) {
  const ProgramRun r = run_stopping("waits", {{"EYEBRIDGE_ROBOTS", "1"},
                                              {"EYEBRIDGE_FAST", "false"},
                                              {"EYEBRIDGE_STEP", "0.2ms"},
                                              {"EYEBRIDGE_FACTOR", "1000000"}});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.err, ::testing::ContainsRegex("warning: the computer was too slow [0-9]+ times"));
}

}  // namespace
}  // namespace eyebridge
