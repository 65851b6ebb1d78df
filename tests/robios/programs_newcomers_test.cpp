// Robots that enter a world in which others run programs.
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "several_robots.hpp"

namespace eyebridge {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::run_named;
using ::testing::StartsWith;

/// A room of 4 m x 4 m, robots in it by the lines of a .sim file, and what they run.
class Newcomers : public ::testing::Test {
 protected:
  Newcomers() {
    folder_.write("room.wld",
                  "floor 4000 4000\n0 0 4000 0\n4000 0 4000 4000\n4000 4000 0 4000\n0 4000 0 0\n");
  }
  testing::ProgramRun run(const std::string& robots, std::map<std::string, std::string> more = {}) {
    more.emplace("EYEBRIDGE_ROBOTS", "all");
    more.emplace("EYEBRIDGE_WORLD", folder_.write("all.sim", "world room.wld\n" + robots));
    return run_named("several_late", more);
  }

  testing::ScratchFolder folder_;
};

/// Two at the start; one comes while they drive, one when all have ended, where the first one was.
constexpr const char* kFour =
    "S4 500 500 0\nS4 500 3500 0\nS4 500 500 0\nenters 3.014\nS4 500 1000 0\nenters 0.5\n";

TEST_F(Newcomers, ComeAtTheirTimesWithTheNextNumbers) {
  const auto r = run(kFour);
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out,
            "1 came at 0 to 500, saw 3435, drove 180\n"
            "2 came at 0 to 500, saw 3435, drove 180\n"
            "3 came at 500 to 500, saw 3435, drove 180\n"
            "4 came at 3020 to 500, saw 434, drove 180\n")  // the first one drives on ahead of it
      << r.err;
  EXPECT_THAT(r.err, HasSubstr("eyebridge: 4 robots, 4.0"));
}

TEST_F(Newcomers, TwentyRunsAreOneRun) {
  std::set<std::string> states;
  for (int i = 0; i < testing::repeats(20); ++i) {
    const auto r = run(kFour);
    states.insert(r.out + testing::trace_of(r.err));
  }
  EXPECT_EQ(states.size(), 1U);
  const auto without = run("S4 500 500 0\nS4 500 3500 0\n");
  EXPECT_THAT(*states.begin(), Not(HasSubstr(testing::trace_of(without.err))));
}

TEST_F(Newcomers, ComeInRealTimeToo) {
  const auto r = run(kFour, testing::kClocks[1]);
  EXPECT_EQ(r.exit_code, 0) << r.err;
  for (const char* number : {"1", "2", "3", "4"}) {
    EXPECT_THAT(r.out, HasSubstr(number + std::string(" came at ")));
  }
  EXPECT_THAT(r.err, HasSubstr("eyebridge: 4 robots, "));
}

TEST_F(Newcomers, OneWhosePlaceIsTakenIsToldOfAndTheOthersGoOn) {
  for (const auto& clock : testing::kClocks) {
    const auto r =
        run("S4 3000 500 0\nS4 3000 600 0\nenters 0.1\nS4 3000 2500 0\nenters 0.2\n", clock);
    EXPECT_EQ(r.exit_code, 1) << r.err;
    EXPECT_THAT(r.err,
                HasSubstr("all.sim:3:1: a robot cannot enter after 0.1 s: S4 (186 mm across) "
                          "at (3000, 600) mm would stand in robot 1: expected a free place"));
    EXPECT_THAT(r.out,
                AllOf(HasSubstr("1 came at"), HasSubstr("2 came at"), Not(HasSubstr("3 came at"))));
  }
}

TEST_F(Newcomers, HaveResultsAndAnEndOfTheirOwn) {
  const auto r = run("S4 500 500 0\nS4 500 1000 0\nenters 0.5\n",
                     {{"EYEBRIDGE_OUT", folder_.path() + "/out"}});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  const auto trace = testing::file_text(folder_.path() + "/out/robot-2/trace.csv");
  EXPECT_THAT(trace.substr(trace.find('\n') + 1), StartsWith("0.510,"));
}

TEST_F(Newcomers, DoNotComeAfterTheTimeLimit) {
  for (const auto& clock : testing::kClocks) {
    auto settings = clock;
    settings.emplace("EYEBRIDGE_TIME_LIMIT", "0.3s");
    const auto r = run("S4 500 500 0\nS4 500 1000 0\nenters 0.3\n", settings);
    EXPECT_EQ(r.exit_code, 0) << r.err;
    EXPECT_THAT(r.err, HasSubstr("eyebridge: 1 robots"));
  }
}

}  // namespace
}  // namespace eyebridge
