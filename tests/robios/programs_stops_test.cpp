// Robots that crash or hang inside the C library, wait for ever, or compute on: the others go on.
#include <array>
#include <cstdlib>
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
using ::testing::ContainsRegex;
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

TEST(RobotsThatStop, OneEndedInALoopAroundTheCLibraryLeavesItUnlocked) {
  for (const char* how : {"takes memory", "prints"}) {
    const ProgramRun r = run_stopping(how, {});
    EXPECT_EQ(r.exit_code, 124) << how << r.err;
    EXPECT_THAT(r.out, kOthersAreDone) << how;
    EXPECT_THAT(r.err,
                AllOf(HasSubstr("robot 2: warning: the program has computed for 0.5 s without a "
                                "call with which its time passes; all robots wait for it"),
                      HasSubstr("robot 2: error: the program has made no call for too long")));
  }
}

TEST(RobotsThatStop, ACrashInTheMiddleOfPrintingLeavesTheOthersTheirOutput) {
  for (const auto& clock : testing::kClocks) {
    const ProgramRun r = run_stopping("prints nothing", clock);
    EXPECT_EQ(r.exit_code, 139) << r.err;
    EXPECT_THAT(r.out, kOthersAreDone);
    // printf() of a string at 0x8: strlen() of arm64 reads from 0x0 on, where its 16 bytes begin.
    EXPECT_THAT(r.err, ContainsRegex("robot 2: error: the program crashed: Segmentation fault at "
                                     "address 0x[08]; it ends, the others go on"));
  }
}

// With the address sanitizer it ends the process itself.
#if !defined(__SANITIZE_ADDRESS__)
TEST(RobotsThatStop, AHeapThatIsLockedForEverEndsTheRunWithAMessage) {
  for (const auto& clock : testing::kClocks) {
    const ProgramRun r = run_stopping("spoils its heap", clock);
    EXPECT_EQ(r.exit_code, 134) << r.err;
    EXPECT_THAT(r.err, AllOf(HasSubstr("robot 2: error: the program crashed: Aborted, inside the C "
                                       "library; the others need what it had locked there: all "
                                       "robots end"),
                             HasSubstr("error: the run is ended; ")));
  }
}
#endif

TEST(RobotsThatStop, OneThatWaitsForAPipeOrASignalIsToldOfAndEnded) {
  for (const auto& [how, call] : Settings{{"reads", "read()"}, {"pauses", "pause()"}}) {
    const ProgramRun r = run_stopping(how, {});
    EXPECT_EQ(r.exit_code, 124) << r.err;
    EXPECT_THAT(r.out, kOthersAreDone);
    EXPECT_THAT(r.err, AllOf(HasSubstr("robot 2: warning: the program has waited for 0.5 s in " +
                                       call + "; all robots wait for it"),
                             HasSubstr("robot 2: error: the program has made no call for too "
                                       "long and is ended; the others go on")));
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
    const ProgramRun r =
        run_stopping("yields", {{"EYEBRIDGE_ROBOTS", robots}, {"EYEBRIDGE_TIME_LIMIT", limit}});
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
