// Several robots that run programs of classic RoBIOS in one process.
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "several_robots.hpp"

namespace eyebridge {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::ProgramRun;
using testing::sorted_lines;
using testing::trace_of;

using Settings = std::map<std::string, std::string>;

constexpr char kSeveral[] = EYEBRIDGE_TEST_PROGRAMS "/several_c 2";
constexpr char kTasks[] = EYEBRIDGE_TEST_PROGRAMS "/several_tasks_c";

/// The program runs for each of `count` robots, and gets their number as argument.
ProgramRun run_several(const std::string& program, const std::string& count, Settings more) {
  more.emplace("EYEBRIDGE_ROBOTS", count);
  more.emplace("EYEBRIDGE_WORLD", EYEBRIDGE_TEST_WORLDS "/rooms.wld");
  return testing::run_program({{EYEBRIDGE_TEST_PROGRAMS "/" + program, count}, more, ""});
}

/// What is to be the same in every run.
std::string result_of(const ProgramRun& run) { return run.out + trace_of(run.err); }

/// A world whose two robots run these programs, started without naming any.
ProgramRun run_scenario(const std::string& first, const std::string& second) {
  const testing::ScratchFolder folder;
  const std::string scenario = folder.write(
      "two.sim", fmt::format("world {}/soccer-field.wld\nS4 700 760 0 {}\nS4 2400 760 180 {}\n",
                             EYEBRIDGE_TEST_WORLDS, first, second));
  return testing::run_program({{EYEBRIDGE_TEST_COMMAND, "run", "--fast", "--world", scenario},
                               testing::trusted(scenario, folder),
                               ""});
}

TEST(SeveralClassicRobots, EachHasItsOwnDevicesTimersAndVariables) {
  for (const auto& clock : testing::kClocks) {
    const ProgramRun r = run_several("several_c", "3", clock);
    EXPECT_EQ(r.exit_code, 0) << r.err;
    EXPECT_THAT(sorted_lines(r.out),
                ElementsAre("1: drives 3 psd 1, latch 1 port 10 var 101 date 1.1.1991 name B, "
                            "timers 16 ticked 0, radio 1 heard 7",
                            "2: drives 1 psd 1, latch 2 port 20 var 102 date 2.2.1992 name C, "
                            "timers 15 ticked 1, radio 2 heard 7",
                            "3: drives 3 psd 1, latch 3 port 30 var 103 date 3.3.1993 name D, "
                            "timers 16 ticked 0, radio 3 heard 7"))
        << r.err;
  }
}

TEST(SeveralClassicRobots, EachHasItsOwnTasks) {
  // Twenty times as fast it would be over within ten milliseconds, too few for each task's turn.
  const Settings real_time{{"EYEBRIDGE_FAST", "false"}, {"EYEBRIDGE_FACTOR", "1"}};
  for (const auto& clock : {testing::kClocks[0], real_time}) {
    const ProgramRun r = run_several("several_tasks_c", "3", clock);
    EXPECT_EQ(r.exit_code, 0) << r.err;
    EXPECT_THAT(sorted_lines(r.out),
                ElementsAre("1: mode 1 got 4 4, computed 1", "2: mode 0 got 4 4, computed 0",
                            "3: mode 1 got 4 4, computed 1"))
        << r.err;
  }
}

TEST(SeveralClassicRobots, ARunRepeatsToTheBit) {
  const auto run = [](const char* program) {
    const ProgramRun r = run_several(program, "4", testing::kClocks[0]);
    EXPECT_EQ(r.exit_code, 0) << r.err;
    return result_of(r);
  };
  for (const char* program : {"several_c", "several_tasks_c"}) {
    const std::string first = run(program);
    ASSERT_THAT(first, HasSubstr("trace "));
    for (int i = 0; i < 5; ++i) EXPECT_EQ(run(program), first);
  }
}

TEST(SeveralClassicRobots, AnEndOfAnyKindIsThatRobotsOwn) {
  for (const auto& clock : testing::kClocks) {
    const ProgramRun r = run_several("several_ends_c", "7", clock);
    EXPECT_EQ(r.exit_code, 5) << r.err;  // the first robot's
    EXPECT_THAT(sorted_lines(r.out), ElementsAre("robot 4 is left", "robot 5 is left",
                                                 "robot 6 is left", "robot 7 is left"));
    EXPECT_THAT(
        r.err, AllOf(HasSubstr("robot 2: error: all tasks wait for each other or are suspended"),
                     HasSubstr("robot 3: error: OSPanic: no way"), Not(HasSubstr("robot 1: error")),
                     Not(HasSubstr("robot 6: error"))));
  }
}

TEST(SeveralClassicRobots, ACrashIsTheRobotsOwnInAProcessOfItsOwn) {
  for (auto clock : testing::kClocks) {
    clock["EYEBRIDGE_ISOLATE"] = "true";
    clock["ASAN_OPTIONS"] = testing::kCrashesAreTheKernels;
    const ProgramRun r = run_several("several_ends_c", "7", clock);
    EXPECT_EQ(r.exit_code, 5) << r.err;
    EXPECT_THAT(sorted_lines(r.out), ElementsAre("robot 6 is left", "robot 7 is left"));
    EXPECT_THAT(r.err, AllOf(HasSubstr("robot 4: error: the program was ended by a signal: "
                                       "Segmentation fault; the others go on"),
                             HasSubstr("robot 5: error: the program was ended by a signal: "
                                       "Segmentation fault; the others go on"),
                             Not(HasSubstr("robot 6: error"))));
  }
}

TEST(SeveralClassicRobots, AWorldNamesTheirPrograms) {
  const ProgramRun r = run_scenario(kTasks, kSeveral);
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(sorted_lines(r.out),
              ElementsAre("1: mode 1 got 4 4, computed 1",
                          "2: drives 1 psd 1, latch 2 port 20 var 102 date 2.2.1992 name C, "
                          "timers 15 ticked 1, radio 2 heard 2"))
      << r.err;
  EXPECT_EQ(result_of(run_scenario(kTasks, kSeveral)), result_of(r));
}

TEST(SeveralClassicRobots, AProgramOfTheOtherGenerationHasAProcessOfItsOwn) {
  const ProgramRun classic_first = run_scenario(kTasks, EYEBRIDGE_TEST_OTHER_PROGRAM);
  EXPECT_EQ(classic_first.exit_code, 0) << classic_first.err;
  EXPECT_THAT(sorted_lines(classic_first.out),
              ElementsAre("1: mode 1 got 4 4, computed 1",
                          "2: counted 7 calls 7 mine 7 camera 320 x 20 at 700 alone"));
  const ProgramRun classic_second = run_scenario(EYEBRIDGE_TEST_OTHER_PROGRAM, kTasks);
  EXPECT_EQ(classic_second.exit_code, 0) << classic_second.err;
  EXPECT_THAT(sorted_lines(classic_second.out),
              ElementsAre("1: counted 6 calls 6 mine 3 camera 160 x 10 at 600 alone",
                          "2: mode 0 got 4 4, computed 0"));
  EXPECT_EQ(trace_of(run_scenario(EYEBRIDGE_TEST_OTHER_PROGRAM, kTasks).err),
            trace_of(classic_second.err));
}

}  // namespace
}  // namespace eyebridge
