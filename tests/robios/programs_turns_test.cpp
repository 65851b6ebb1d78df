// Threads of a program that is the only robot: in virtual time they take turns.
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "named_program.hpp"
#include "processors.hpp"

namespace eyebridge {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::run_named;
using ::testing::SizeIs;

constexpr const char* kWaits =
    "future 7 at 500, looked 5 times\n"
    "latch after 30\n"
    "barrier after 30\n"
    "semaphore 0 after 100, then after 300\n"
    "mutex 0 after 50, then after 200\n"
    "writer 0 after 50, then after 200\n"
    "reader 0, then after 200\n"
    "all at 1460\n";

TEST(ProgramTurns, ThreadsWaitForEachOtherInEveryWay) {
  const auto r = run_named("waits");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.err, "");
  EXPECT_EQ(r.out, kWaits);
}

TEST(ProgramTurns, AThreadThatSpinsLetsTheOthersGoOn) {
  const auto r = run_named("spins");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, ::testing::StartsWith("counted at 2"));
  EXPECT_THAT(r.err, HasSubstr("a thread of the program has computed for 2 s without a call"));
  EXPECT_EQ(r.err.find("computed"), r.err.rfind("computed")) << "told once";
}

TEST(ProgramTurns, ThreadsThatWaitForEachOtherForEverEnd) {
  const auto r = run_named("several_stuck");
  EXPECT_EQ(r.exit_code, 1);
  EXPECT_THAT(r.err, HasSubstr("error: all threads of the program wait for each other, and nobody "
                               "else can wake one of them; it ends"));
}

TEST(ProgramTurns, TheSameThreadsOfOneOfSeveralDoTheSame) {
  const auto alone = run_named("several_crew");
  EXPECT_EQ(alone.exit_code, 0) << alone.err;
  EXPECT_EQ(alone.err, "");
  EXPECT_EQ(alone.out, "1: took 5, late after 760 ms, 0\n");
}

TEST(ProgramTurns, ThreadsMayWaitForWhatTheLibraryDoesNotKnow) {
  const auto r = run_named("system_threads");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.err, "");
  EXPECT_EQ(r.out,
            "read 5 at 500\n"
            "0 of mine at 500\n"
            "met at 530\n"
            "left 5 at 530\n"
            "the child's thread says 42\n"
            "select, poll 500\n"
            "until then 2500\n"
            "until that time of day 3500\n"
            "looked at the clock until 4000\n");
}

TEST(ProgramTurns, ThreadsHaveDataAndBarriersOfTheirOwn) {
  const std::string what = ": mine 1, of a 1, of b 2, destroyed 3, met at 130, last 01, at 130\n";
  const auto alone = run_named("several_threads");
  EXPECT_EQ(alone.out, "1" + what) << alone.err;
  const auto two = run_named("several_threads", {{"EYEBRIDGE_ROBOTS", "2"}});
  EXPECT_EQ(two.exit_code, 0) << two.err;
  EXPECT_THAT(two.out, HasSubstr("1" + what));
  EXPECT_THAT(two.out, HasSubstr("2" + what));
}

TEST(ProgramTurns, ThreadsMayOutliveMainAndTheirVariablesThem) {
  const auto r = run_named("outlives");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out, "at 600\npolled 0, then 1 after 30\njoined, 0 left\n");
  const auto cut = run_named("outlives", {{"EYEBRIDGE_TIME_LIMIT", "0.25"}});
  EXPECT_EQ(cut.exit_code, 0) << cut.err;
  EXPECT_EQ(cut.out, "joined, 0 left\n");
}

TEST(ProgramTurns, ThreadsOfC11AreThreads) {
  const std::string what = ": 101 100 102, 946684800, late 1 at 2100\n";
  const auto alone = run_named("c11_threads");
  EXPECT_EQ(alone.out, "1" + what) << alone.err;
  const auto two = run_named("c11_threads", {{"EYEBRIDGE_ROBOTS", "2"}});
  EXPECT_EQ(two.exit_code, 0) << two.err;
  EXPECT_THAT(two.out, HasSubstr("1" + what));
  EXPECT_THAT(two.out, HasSubstr("2" + what));
}

// The last wait ends with the run.
TEST(ProgramTurns, WaitsEndAtTheirTimeOrWhereATimerEndsThem) {
  const auto r = run_named("long_waits", {{"EYEBRIDGE_TIME_LIMIT", "4"}});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.err, "");
  EXPECT_EQ(r.out,
            "ppoll 0, pselect 0, epoll_wait 0 at 300\n"
            "given at 500\n"
            "joined 1 at 1000, 0 at 1500\n"
            "wrong 1 1 at 1500\n");
}

#if !defined(__SANITIZE_ADDRESS__)  // it stumbles over threads that are cancelled
TEST(ProgramTurns, ThreadsCanBeCancelled) {
  const auto alone = run_named("cancels");
  EXPECT_EQ(alone.out, "1: cancelled 111, free 1, taken 1, at 150\n") << alone.err;
  const auto two = run_named("cancels", {{"EYEBRIDGE_ROBOTS", "2"}});
  EXPECT_EQ(two.exit_code, 0) << two.err;
  EXPECT_THAT(two.out, HasSubstr("1: cancelled 111, free 1, taken 1, at 150\n"));
}
#endif

TEST(ProgramTurns, TimeIsTheRobotsFromTheFirstLookOn) {
  EXPECT_EQ(run_named("looks").out, "946684800, 2 s, 2 s, at 2000\n");
  const auto wall = run_named("looks", {{"EYEBRIDGE_FAST", "false"}, {"EYEBRIDGE_FACTOR", "100"}});
  EXPECT_THAT(wall.out, ::testing::Not(::testing::StartsWith("9466848"))) << wall.err;
}

std::string file(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

constexpr int kTimes = testing::repeats(10);

/// What `robots` robots that run `program` print, and the state of their world, in some runs, half
/// of them on one busy processor.
std::set<std::string> results_of(const std::string& program, const std::string& robots) {
  const testing::ScratchFolder folder;
  const std::string report = folder.path() + "/report";
  const std::string world = std::string(EYEBRIDGE_TEST_WORLDS) + "/rooms.wld";
  std::set<std::string> seen;
  const auto run = [&] {
    const auto r = run_named(
        program,
        {{"EYEBRIDGE_REPORT", report}, {"EYEBRIDGE_ROBOTS", robots}, {"EYEBRIDGE_WORLD", world}});
    EXPECT_EQ(r.exit_code, 0) << r.err;
    // Those who end at once may print in any order.
    std::multiset<std::string> lines;
    std::istringstream text(r.out);
    for (std::string line; std::getline(text, line);) lines.insert(line);
    std::string all = file(report);
    for (const std::string& line : lines) all += line + '\n';
    seen.insert(all);
  };
  for (int i = 0; i < kTimes; ++i) run();
  // Each switch between processes would wait for the busy thread's turn: up to minutes a run.
  if (robots != "1") return seen;
  const testing::OneBusyProcessor one;
  for (int i = 0; i < kTimes; ++i) run();
  return seen;
}

TEST(ProgramTurns, RunsOfProcessesWithThreadsThatReadSensorsRepeat) {
  const std::set<std::string> seen = results_of("senses", "2");
  EXPECT_THAT(seen, SizeIs(1));
  EXPECT_THAT(*seen.begin(),
              AllOf(HasSubstr("state_hash = "), HasSubstr("\n1: "), HasSubstr("\n2: ")));
}

TEST(ProgramTurns, RunsOfOneWithThreadsThatReadSensorsRepeat) {
  EXPECT_THAT(results_of("senses", "1"), SizeIs(1));
}

TEST(ProgramTurns, RunsWithThreadsRepeat) {
  const testing::ScratchFolder folder;
  const std::string report = folder.path() + "/report";
  std::set<std::string> seen;
  for (int i = 0; i < testing::repeats(20); ++i) {
    const auto r = run_named("several_crew", {{"EYEBRIDGE_REPORT", report}});
    seen.insert(r.out + r.err + file(report));
  }
  EXPECT_THAT(seen, SizeIs(1));
  EXPECT_THAT(*seen.begin(), HasSubstr("state_hash = "));
}

}  // namespace
}  // namespace eyebridge
