// What the C library keeps once in a process is each robot's of several.
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "several_robots.hpp"

namespace eyebridge {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::several;
using testing::sorted_lines;
using Words = std::vector<std::string>;

testing::ProgramRun run_with(const std::string& program, const Words& words,
                             std::map<std::string, std::string> settings) {
  settings.emplace("EYEBRIDGE_FAST", "true");
  Words command{std::string(EYEBRIDGE_TEST_PROGRAMS) + "/" + program};
  command.insert(command.end(), words.begin(), words.end());
  return testing::run_program({command, settings, ""});
}

/// By robots, of whose numbers each line has one; in real time they print as the computer lets
/// them.
std::string by_robot(const std::string& text) {
  std::map<char, std::string> robots;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    robots[line[line.find_first_of("123456789")]] += line + "\n";
  }
  std::string all;
  for (const auto& [robot, lines] : robots) all += lines;
  return all;
}

/// What `program` prints alone, so many times.
std::string alone(const std::string& program, const Words& words, int times) {
  const std::string once = run_with(program, words, several("1")).out;
  EXPECT_NE(once, "");
  std::string all;
  for (int i = 0; i < times; ++i) all += once;
  return all;
}

TEST(SeveralRobots, EachReadsItsOwnOptions) {
  const Words words = {"one", "--speed", "120", "-l"};
  const auto r = run_with("several_options", words, several("3", testing::kClocks[0]));
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(sorted_lines(r.out), ElementsAre("1: 120 1 one", "2: 120 1 one", "3: 120 1 one"));
}

TEST(SeveralRobots, DrawTheNumbersOfAnOnlyRobot) {
  for (const auto& clock : testing::kClocks) {
    const auto r = run_with("several_numbers", {}, several("3", clock));
    EXPECT_EQ(r.exit_code, 0) << r.err;
    EXPECT_EQ(r.out, alone("several_numbers", {}, 3));
  }
}

TEST(SeveralRobots, EndByThemselvesWhereAProcessWouldEndAtOnce) {
  for (const auto& clock : testing::kClocks) {
    const auto r = run_with("several_exits", {}, several("7", clock));
    EXPECT_EQ(r.exit_code, 3) << r.err;
    EXPECT_EQ(by_robot(r.out),
              "robot 1 goes\nrobot 2 goes\nrobot 3 goes\nrobot 3 hurries\n"
              "robot 4 goes\nrobot 4 says goodbye\nrobot 5 goes\nrobot 5 says goodbye\n"
              "robot 6 goes\nrobot 6 says goodbye\nrobot 7 goes\nrobot 7 says goodbye\n");
    EXPECT_THAT(r.err, AllOf(HasSubstr("robot 1: warning: the program ended with exit code 3\n"),
                             HasSubstr("robot 2: warning: the program ended with exit code 4\n"),
                             HasSubstr("robot 3: warning: the program ended with exit code 5\n"),
                             HasSubstr(": trouble\n"), HasSubstr(": more trouble\n"),
                             HasSubstr("robot 4: warning: the program ended with exit code 6\n"),
                             HasSubstr("robot 5: warning: the program ended with exit code 7\n"),
                             Not(HasSubstr("robot 6: ")), HasSubstr("eyebridge: 7 robots, ")));
  }
}

TEST(SeveralRobots, EachHasItsLastWordsInItsOwnProgram) {
  for (const auto& clock : testing::kClocks) {
    const auto r = run_with("several_last_words", {}, several("4", clock));
    EXPECT_EQ(r.exit_code, 8) << r.err;
    EXPECT_EQ(by_robot(r.out),
              "1 did well\n1 exits\n1 exits again\n1 ends what began late\n1 stops\n1 is done\n"
              "2 failed\n2 exits\n2 exits again\n2 ends what began late\n2 stops\n2 is done\n"
              "3 did well\n3 exits\n3 exits again\n3 ends what began late\n3 stops\n3 is done\n");
    EXPECT_THAT(r.err,
                HasSubstr("robot 4: error: the program called abort()"));  // and says nothing
  }
}

TEST(SeveralRobots, WhatTheyShareEndsWithTheLastOfThem) {
  const auto r =
      run_with("several_last_words", {}, several("3", {{"EYEBRIDGE_SHARED_GLOBALS", "true"}}));
  EXPECT_EQ(r.exit_code, 9) << r.err;
  EXPECT_EQ(sorted_lines(r.out).front(), "3 did well");
  EXPECT_THAT(r.out, AllOf(HasSubstr("3 stops\n3 is done\n"), Not(HasSubstr("1 stops"))));
}

TEST(SeveralRobots, WhatBeganInThemEndsAtTheTimeLimit) {
  const auto r =
      run_with("several_last_words", {}, several("2", {{"EYEBRIDGE_TIME_LIMIT", "0.5s"}}));
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, AllOf(HasSubstr(" is done\n"), Not(HasSubstr(" exits"))));
}

TEST(SeveralRobots, HandleSignalsByThemselves) {
  for (const auto& clock : testing::kClocks) {
    const auto r = run_with("several_signals", {}, several("4", clock));
    EXPECT_EQ(r.exit_code, 21) << r.err;
    EXPECT_THAT(sorted_lines(r.out),
                ElementsAre("1 counted 2, and recovered", "1 gives up by 11 at 0x8",
                            "2 counted 0, and recovered", "3 counted 6, and recovered"));
    EXPECT_THAT(r.err,
                AllOf(HasSubstr("robot 1: warning: the program ended with exit code 21\n"),
                      HasSubstr("robot 4: error: the program was ended by a signal: User defined "
                                "signal 1; the others go on")));
  }
}

TEST(SeveralRobots, MayMakeProcessesThatEndInAnyWay) {
  for (const auto& clock : testing::kClocks) {
    const auto r = run_with("several_children", {}, several("6", clock));
    EXPECT_EQ(r.exit_code, 0) << r.err;
    EXPECT_THAT(sorted_lines(r.out), ElementsAre("1 had 0 31", "2 had 0 8", "3 had 0 9",
                                                 "4 had 11 0", "5 had 0 1", "6 had 0 7"));
    EXPECT_THAT(r.err, HasSubstr("OSWait: called in a forked process"));
  }
}

TEST(SeveralRobots, EachHasItsOwnLibraries) {
  for (const auto& clock : testing::kClocks) {
    const auto r = run_with("several_library", {}, several("2", clock));
    EXPECT_EQ(r.exit_code, 0) << r.err;
    EXPECT_THAT(sorted_lines(r.out), ElementsAre("1 counted to 3", "2 counted to 3"));
  }
  const auto shared =
      run_with("several_library", {}, several("2", {{"EYEBRIDGE_SHARED_GLOBALS", "true"}}));
  EXPECT_THAT(sorted_lines(shared.out), ElementsAre("1 counted to 5", "2 counted to 6"));
}

}  // namespace
}  // namespace eyebridge
