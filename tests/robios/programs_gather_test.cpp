// At their first call the programs of several robots wait for each other: no robot moves before all
// are there.
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "several_robots.hpp"

namespace eyebridge {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;

/// Three robots side by side in a room of 4 m x 4 m, that drive once all are there.
class Gathering : public ::testing::Test {
 protected:
  Gathering() {
    folder_.write("room.wld",
                  "floor 4000 4000\n0 0 4000 0\n4000 0 4000 4000\n4000 4000 0 4000\n0 4000 0 0\n");
  }
  /// What each does before its first call, as words of gathers.c; "apart" before: in a process of
  /// its own.
  testing::ProgramRun run(const std::vector<std::string>& robots, const std::string& more = "",
                          std::map<std::string, std::string> settings = testing::kClocks[0]) {
    std::string text = "world room.wld\n";
    int y = 0;
    for (const std::string& how : robots) {
      const bool is_apart = how.starts_with("apart ");
      text += "S4 500 " + std::to_string(y += 500) + " 0 " + EYEBRIDGE_TEST_PROGRAMS +
              (is_apart ? "/gathers_apart " + how.substr(6) : "/gathers " + how) + '\n';
    }
    const std::string scenario = folder_.write("all.sim", text + more);
    settings.emplace("EYEBRIDGE_WORLD", scenario);
    settings.merge(testing::trusted(scenario, folder_));
    return testing::run_program({{EYEBRIDGE_BIN "/eyebridge", "run"}, settings, ""});
  }

  testing::ScratchFolder folder_;
};

constexpr const char* kAllAt700 =
    "1 at 700 drove 80\n"
    "2 at 700 drove 80\n"
    "3 at 700 drove 80\n";

TEST_F(Gathering, NobodyMovesBeforeTheLastOneIsThere) {
  const auto at_once = run({"0", "0", "0"});
  EXPECT_EQ(at_once.out,
            "1 at 0 drove 80\n"
            "2 at 0 drove 80\n"
            "3 at 0 drove 80\n")
      << at_once.err;
  EXPECT_EQ(run({"700", "0", "0"}).out, kAllAt700);
  EXPECT_EQ(run({"0", "700", "0"}).out, kAllAt700);
  EXPECT_EQ(run({"0", "0", "700"}).out, kAllAt700);
  EXPECT_EQ(run({"300", "700", "10"}).out, kAllAt700);
}

TEST_F(Gathering, ProgramsInProcessesWaitAndAreWaitedFor) {
  for (const char* sleeps : {"700", "t700"}) {
    for (int last = 0; last < 3; ++last) {
      std::vector<std::string> robots{"apart 0", "apart t0", "0"};
      robots[static_cast<std::size_t>(last)] =
          (last < 2 || *sleeps == 't' ? "apart " : "") + std::string(sleeps);
      const auto r = run(robots);
      EXPECT_EQ(r.exit_code, 0) << r.err;
      for (const char* line : {"1 at 700 drove 80", "2 at 700 drove 80", "3 at 700 drove 80"}) {
        EXPECT_THAT(r.out, HasSubstr(line)) << r.err;
      }
    }
  }
  auto settings = testing::kClocks[0];
  settings.emplace("EYEBRIDGE_FAULTS", "psd:1 delay 20ms");  // stands before the robot
  EXPECT_THAT(run({"apart 0", "700"}, "", settings).out, HasSubstr("1 at 700 drove 80"));
}

TEST_F(Gathering, NobodyWaitsForOneThatEndsWithoutACall) {
  for (const char* quits : {"q700", "apart q700"}) {
    EXPECT_EQ(run({"0", quits, "0"}).out,
              "1 at 700 drove 80\n"
              "3 at 700 drove 80\n");
  }
  EXPECT_EQ(run({"q0", "0", "q0"}).out, "2 at 0 drove 80\n");
  EXPECT_EQ(run({"q10", "q20", "q0"}).out, "");
}

TEST_F(Gathering, NobodyWaitsForOneThatNeverCan) {
  const auto r = run({"0", "apart s", "300"});
  EXPECT_EQ(r.exit_code, 1);
  EXPECT_EQ(r.out,
            "1 at 300 drove 80\n"
            "3 at 300 drove 80\n");
  EXPECT_THAT(r.err,
              AllOf(HasSubstr("robot 2: error: all threads of the program wait for each other"),
                    Not(HasSubstr("robot 1: error"))));
}

TEST_F(Gathering, OneThatIsLateForAMinuteIsToldOf) {
  const auto r = run({"0", "0", "61000"});
  EXPECT_THAT(r.err, HasSubstr("warning: 1 of 3 robots have made no call in the first 60 s of"));
  EXPECT_THAT(r.out, HasSubstr("1 at 61000 drove"));
  EXPECT_THAT(run({"0", "0", "59000"}).err, Not(HasSubstr("have made no call")));
}

TEST_F(Gathering, ATimeLimitEndsThoseWhoWait) {
  const auto r =
      run({"0", "9000", "0"}, "", {{"EYEBRIDGE_FAST", "true"}, {"EYEBRIDGE_TIME_LIMIT", "2"}});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out, "");
  EXPECT_THAT(r.err, HasSubstr("3 robots, 2.00 s"));
}

TEST_F(Gathering, NewcomersWaitButAreNotWaitedFor) {
  const std::string late = "S4 500 3000 0 " EYEBRIDGE_TEST_PROGRAMS "/gathers 100\nenters 0.2\n";
  const auto r = run({"700", "0", "0"}, late);
  EXPECT_EQ(r.out, std::string(kAllAt700) + "4 at 700 drove 80\n") << r.err;
  const auto sooner = run({"0", "0", "100"}, late);
  EXPECT_THAT(sooner.out, HasSubstr("4 at 300 drove 80\n")) << sooner.err;
}

TEST_F(Gathering, InRealTimeTheClockBeginsThen) {
  const auto r = run({"0", "200", "apart 0"}, "", testing::kClocks[1]);
  EXPECT_EQ(r.exit_code, 0) << r.err;
  for (const char* number : {"1", "2", "3"}) {
    EXPECT_THAT(r.out, HasSubstr(number + std::string(" at ")));
  }
}

TEST_F(Gathering, RunsRepeat) {
  std::set<std::string> seen;
  for (int i = 0; i < testing::repeats(5); ++i) {
    const auto r = run({"apart 30", "apart t700", "500"});
    seen.insert(testing::trace_of(r.err));
  }
  EXPECT_THAT(seen, SizeIs(1));
}

}  // namespace
}  // namespace eyebridge
