// eyebridge assess, from outside. Control files: tests/python/test_assess.py.

#include <filesystem>
#include <map>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "many_runs.hpp"

namespace eyebridge {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::ProgramRun;
using testing::run_command;

using Row = std::map<std::string, std::string>;

class Assess : public testing::ManyRuns {
 protected:
  ProgramRun assess(std::vector<std::string> words) {
    words.insert(words.begin(), "assess");
    return run_command(words, folder_.path());
  }
  /// A table that holds no quotes, by its names.
  std::vector<Row> table(const std::string& file) {
    std::istringstream text(testing::file_text(folder_.path() + "/assessment/" + file));
    const auto fields = [](const std::string& line) {
      std::vector<std::string> out(1);
      for (const char c : line) {
        if (c == ',') {
          out.emplace_back();
        } else {
          out.back() += c;
        }
      }
      return out;
    };
    std::string line;
    std::getline(text, line);
    const std::vector<std::string> names = fields(line);
    std::vector<Row> rows;
    while (std::getline(text, line)) {
      const std::vector<std::string> values = fields(line);
      EXPECT_EQ(values.size(), names.size()) << line;
      Row& row = rows.emplace_back();
      for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = values.at(i);
    }
    return rows;
  }

  const std::string cell_ = EYEBRIDGE_TEST_ASSESS_CELL;
  const std::string room_ = EYEBRIDGE_SOURCE_DIR "/worlds/empty-room.wld";    // from 1000, 1000
  const std::string corridor_ = EYEBRIDGE_SOURCE_DIR "/worlds/corridor.wld";  // from 300, 300
};

TEST_F(Assess, CountsWhoReachesTheGoalOfItsWorld) {
  const ProgramRun r =
      assess({"--worlds", room_ + "," + corridor_, "--seeds", "2", "--goal",
              "empty-room.wld:1500,1000,20", "--goal", corridor_ + ":900,300,20", cell_, "500"});
  ASSERT_EQ(r.exit_code, 0) << r.err;
  const std::vector<Row> runs = table("runs.csv");
  ASSERT_EQ(runs.size(), 4U);
  for (const Row& run : runs) EXPECT_NEAR(std::stod(run.at("path_m")), 0.5, 0.005);
  EXPECT_EQ(runs[0].at("verdict"), "success");
  EXPECT_NEAR(std::stod(runs[0].at("end_x_m")), 1.5, 0.005);
  EXPECT_EQ(runs[2].at("group"), "corridor.wld");
  EXPECT_EQ(runs[3].at("seed"), "2");
  EXPECT_EQ(runs[2].at("verdict"), "goal missed");
  EXPECT_NEAR(std::stod(runs[2].at("goal_distance_m")), 0.1, 0.005) << "at 800 of 900 mm";
  EXPECT_THAT(runs[2].at("reason"), HasSubstr("m from the goal's centre"));
  const std::vector<Row> summary = table("summary.csv");
  ASSERT_EQ(summary.size(), 3U);
  EXPECT_EQ(summary[0].at("success_rate"), "1");
  EXPECT_EQ(summary[1].at("success_rate"), "0");
  EXPECT_EQ(summary[1].at("path_m_median"), "") << "of a failure it says nothing";
  EXPECT_EQ(summary[2].at("group"), "all");
  EXPECT_EQ(summary[2].at("success_rate"), "0.5");
  EXPECT_NEAR(std::stod(summary[2].at("wilson_low")), 0.15004, 1e-5);
  EXPECT_NEAR(std::stod(summary[2].at("wilson_high")), 0.84996, 1e-5);
  EXPECT_NEAR(std::stod(summary[2].at("path_m_median")), 0.5, 0.005);
  EXPECT_THAT(r.out,
              HasSubstr("all: 2 of 4 runs succeed, 50.0 % (15.0 ... 85.0 %), 2 goal missed"));
  EXPECT_THAT(r.out, HasSubstr("all runs are the same: the seed changes nothing"));
  for (const char* picture : {"success.png", "time_s.png", "path_m.png", "collisions.png"}) {
    EXPECT_EQ(testing::file_text(folder_.path() + "/assessment/" + picture).substr(1, 3), "PNG");
  }
  EXPECT_FALSE(fs::exists(folder_.path() + "/assessment/coverage.png")) << "it has no belief";
}

TEST_F(Assess, JudgesWhatWasRunByOtherCriteriaWithoutARun) {
  const std::vector<std::string> words = {"--worlds", room_, "--seeds", "1", cell_, "300"};
  ASSERT_EQ(assess(words).exit_code, 0);
  EXPECT_EQ(table("runs.csv").at(0).at("verdict"), "success");
  std::vector<std::string> stricter = {"--goal", "1000,1000,299"};
  stricter.insert(stricter.end(), words.begin(), words.end());
  const ProgramRun r = assess(stricter);
  ASSERT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.err, Not(HasSubstr("1/1"))) << "it ran again";
  EXPECT_EQ(table("runs.csv").at(0).at("verdict"), "goal missed");
}

TEST_F(Assess, EndsOfOtherKindsAreFailuresAndStopNoOtherRun) {
  write_program(
      "prog",
      "#!/bin/sh\ncase \"$EYEBRIDGE_PLAN\" in\n*seed=1*) echo 'no, \"never\"' >&2; exit 3;;\n"
      "*seed=2*) kill -SEGV $$;;\nesac\nexec " +
          cell_ + " $1\n");
  const ProgramRun r = assess({"--worlds", room_, "--seeds", "4", "--goal", "1500,1000,20",
                               "--time-limit", "10s", "./prog", "500"});
  ASSERT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("empty-room.wld: 2 of 4 runs succeed, 50.0 %"));
  EXPECT_THAT(r.out, HasSubstr("1 crashed, 1 failed"));
  const std::string runs = testing::file_text(folder_.path() + "/assessment/runs.csv");
  EXPECT_THAT(runs, HasSubstr("empty-room.wld,1,0,failed,\"exit code 3: no, \"\"never\"\""));
  EXPECT_THAT(runs, HasSubstr("empty-room.wld,2,0,crashed,SIGSEGV"));
  EXPECT_THAT(runs, HasSubstr("empty-room.wld,4,1,success,,"));
}

TEST_F(Assess, WhoIsStoppedByTheTimeLimitFails) {
  ASSERT_EQ(
      assess({"--worlds", room_, "--seeds", "1", "--time-limit", "1s", cell_, "500"}).exit_code, 0);
  const Row run = table("runs.csv").at(0);
  EXPECT_EQ(run.at("verdict"), "time limit");
  EXPECT_EQ(run.at("reason"), "no end before the time limit");
}

TEST_F(Assess, ACollisionFailsWhereThereMayBeNone) {
  // The wall is 1 m ahead of the robot's centre.
  const std::vector<std::string> words = {"--worlds",        room_, "--seeds", "1",
                                          "--stall-timeout", "1s",  cell_,     "1200"};
  ASSERT_EQ(assess(words).exit_code, 0);
  const Row lenient = table("runs.csv").at(0);
  EXPECT_EQ(lenient.at("collisions"), "1");
  EXPECT_EQ(lenient.at("verdict"), "success") << lenient.at("reason");
  std::vector<std::string> strict = {"--no-collisions"};
  strict.insert(strict.end(), words.begin(), words.end());
  ASSERT_EQ(assess(strict).exit_code, 0);
  EXPECT_EQ(table("runs.csv").at(0).at("verdict"), "collision");
  EXPECT_EQ(table("runs.csv").at(0).at("reason"), "1 collision");
}

TEST_F(Assess, ComparesWhatElseIsVaried) {
  const ProgramRun r = assess({"--worlds", room_, "--seeds", "1", "--parameter", "way=200",
                               "--parameter", "way=400", cell_, "{way}"});
  ASSERT_EQ(r.exit_code, 0) << r.err;
  const std::vector<Row> summary = table("summary.csv");
  ASSERT_EQ(summary.size(), 3U);
  EXPECT_EQ(summary[0].at("group"), "empty-room.wld way=200");
  EXPECT_NEAR(std::stod(summary[0].at("path_m_median")), 0.2, 0.005);
  EXPECT_NEAR(std::stod(summary[1].at("path_m_median")), 0.4, 0.005);
}

TEST_F(Assess, RefusesBeforeTheFirstRunWhatCannotBe) {
  write_program("prog", "#!/bin/sh\ntouch " + folder_.path() + "/started\n");
  const auto with = [&](std::vector<std::string> words) {
    words.emplace_back("./prog");
    return assess(words);
  };
  expect_refused(with({}), "--worlds: found none, expected files");
  expect_refused(with({"--worlds", room_ + ",,x"}), "expected files with commas between");
  expect_refused(with({"--worlds", room_ + "," + room_}), "twice, expected each world once");
  expect_refused(with({"--worlds", "gone.maz"}), "gone.maz");
  const auto in_room = [&](const std::string& flag, const std::string& text) {
    return with({"--worlds", room_, flag, text});
  };
  expect_refused(in_room("--seeds", "0"), "--seeds: found 0, expected how many");
  expect_refused(in_room("--seeds", "many"), "--seeds: found 'many'");
  expect_refused(in_room("--seeds", "5..2"), "--seeds: found '5..2'");
  expect_refused(in_room("--goal", "1,2"), "--goal: found '1,2', expected X,Y,RADIUS in mm");
  expect_refused(in_room("--goal", "1,2,nan"), "--goal: found '1,2,nan'");
  expect_refused(in_room("--goal", "1,2,0"), "a radius of more than 0");
  expect_refused(in_room("--goal", "2100,5,9"), "--goal: found (2100, 5) mm, expected a place in ");
  expect_refused(in_room("--goal", "maze.maz:1,2,3"), "found world 'maze.maz', expected one of");
  expect_refused(with({"--worlds", room_, "--goal", "none", "--goal", "1,2,3"}),
                 "expected it alone");
  expect_refused(with({"--worlds", room_, "--goal", "1,2,3", "--goal", "1,2,4"}),
                 "as a second goal");
  expect_refused(in_room("--time-limit", "soon"), "soon");
  EXPECT_FALSE(fs::exists(folder_.path() + "/assessment")) << "nothing is left behind";
  expect_refused(in_room("--out", "prog"), "--out: cannot make the folder prog");
  expect_refused(in_room("--report", "x"), "--report: found 'report'");
  expect_refused(assess({"--worlds", room_}), "found no controller, expected: eyebridge assess");
  expect_refused(assess({"--worlds", room_, "./gone.py"}), "./gone.py: no such program");
  expect_refused(assess({"--worlds", room_, "x.toml"}), "found a sweep file");
  expect_refused(assess({"--wolrds", room_}), "--wolrds");
}

TEST_F(Assess, AnotherVersionOfAControllerWantsAnotherFolder) {
  write_program("prog", "#!/bin/sh\nexit 0\n");
  ASSERT_EQ(assess({"--worlds", room_, "--seeds", "1", "./prog"}).exit_code, 0);
  write_program("prog", "#!/bin/sh\nexit 1\n");
  const ProgramRun r = assess({"--worlds", room_, "--seeds", "1", "./prog"});
  EXPECT_EQ(r.exit_code, 2);
  EXPECT_THAT(r.err, HasSubstr("another version of"));
  EXPECT_THAT(r.err, HasSubstr("(--out)"));
}

}  // namespace
}  // namespace eyebridge
