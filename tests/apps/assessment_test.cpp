// How runs are judged, and what is counted of them.

#include "sweep/assessment.hpp"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run_program.hpp"
#include "sweep/assessment_output.hpp"

namespace eyebridge::apps {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

Cell cell_in(const std::string& world, const std::string& seed) {
  return {"/bin/p", {}, {{"seed", seed}, {"world", world}}, {}, {}};
}

ResultRow row_of(const Cell& cell, const std::string& how, std::map<std::string, double> values) {
  ResultRow row;
  row.key = cell.key();
  for (const auto& [name, value] : cell.coordinates()) row.coordinates[name] = value;
  row.how = how;
  row.values = std::move(values);
  row.state_hash = "00000000000000ff";
  return row;
}

AssessedRun judged(const std::string& how, std::map<std::string, double> values,
                   const Criteria& criteria) {
  const Cell cell = cell_in("/w/a.maz", "1");
  return assess_runs({row_of(cell, how, std::move(values))}, {cell}, criteria).at(0);
}

TEST(Wilson, IsThatOfThePaper) {
  // By hand from the formula of 1927 with z = 1.96; the first is in many tables.
  const Interval half = wilson_interval(5, 10);
  EXPECT_NEAR(half.low, 0.2366, 5e-5);
  EXPECT_NEAR(half.high, 0.7634, 5e-5);
  const Interval none = wilson_interval(0, 10);
  EXPECT_EQ(none.low, 0.0);
  EXPECT_NEAR(none.high, 0.2775, 5e-5) << "z² / (n + z²)";
  const Interval all = wilson_interval(10, 10);
  EXPECT_NEAR(all.low, 1 - none.high, 1e-12);
  EXPECT_EQ(all.high, 1.0);
}

TEST(Quantile, LiesOnTheLineBetweenNeighbours) {
  EXPECT_EQ(quantile({3, 1, 2}, 0.5), 2.0);
  EXPECT_EQ(quantile({4, 1, 3, 2}, 0.5), 2.5);
  EXPECT_EQ(quantile({4, 1, 3, 2}, 0.25), 1.75);
  EXPECT_EQ(quantile({4, 1, 3, 2}, 1), 4.0);
  EXPECT_EQ(quantile({7}, 0.5), 7.0);
}

TEST(Assessment, OnlyWhoEndedByItselfSucceeds) {
  EXPECT_TRUE(judged("ended", {}, {}).success());
  for (const char* how : {"time limit", "failed", "crashed", "hung", "not started"}) {
    EXPECT_EQ(judged(how, {}, {}).verdict, how);
    EXPECT_FALSE(judged(how, {}, {}).success());
  }
}

TEST(Assessment, TheEdgeOfAGoalBelongsToIt) {
  Criteria criteria;
  criteria.goal = Goal{{1.0, 2.0}, 0.5};
  const AssessedRun in = judged("ended", {{"end_x", 1.0}, {"end_y", 2.5}}, criteria);
  EXPECT_TRUE(in.success()) << in.reason;
  EXPECT_EQ(in.goal_distance, 0.5);
  const AssessedRun out = judged("ended", {{"end_x", 1.0}, {"end_y", 1.25}}, criteria);
  EXPECT_EQ(out.verdict, "goal missed");
  EXPECT_EQ(out.reason, "ended 0.750 m from the goal's centre");
  EXPECT_EQ(judged("ended", {}, criteria).verdict, "no robot");
  criteria.goals["/w/a.maz"] = Goal{{1.0, 1.0}, 0.3};
  EXPECT_TRUE(judged("ended", {{"end_x", 1.0}, {"end_y", 1.25}}, criteria).success())
      << "a world's own goal counts";
}

TEST(Assessment, TheFirstThingWrongIsTheVerdictAndAllAreReasons) {
  Criteria criteria;
  criteria.no_collisions = true;
  criteria.goal = Goal{{0.0, 0.0}, 1.0};
  const AssessedRun run =
      judged("ended", {{"end_x", 3.0}, {"end_y", 4.0}, {"collisions", 2.0}}, criteria);
  EXPECT_EQ(run.verdict, "goal missed");
  EXPECT_EQ(run.reason, "ended 5.000 m from the goal's centre; 2 collisions");
}

/// Two worlds of one name and a run in another order than the cells; the third cell has not run.
std::vector<AssessedRun> some_runs() {
  const std::vector<Cell> cells = {cell_in("/w/a.maz", "1"), cell_in("/w/a.maz", "2"),
                                   cell_in("/w/b.maz", "1"), cell_in("/v/b.maz", "1"),
                                   cell_in("/w/a.maz", "3")};
  return assess_runs(
      {row_of(cells[4], "time limit", {{"time", 60.0}, {"collisions", 4.0}}),
       row_of(cells[1], "ended", {{"time", 3.0}, {"collisions", 0.0}, {"score", 0.5}}),
       row_of(cells[0], "ended", {{"time", 2.0}, {"collisions", 1.0}}),
       row_of(cells[3], "ended", {{"time", 9.0}}),
       row_of(cell_in("/w/other.maz", "1"), "ended", {{"time", 99.0}})},
      cells, {});
}

TEST(Assessment, CountsByWorldAndOverAll) {
  const std::vector<Score> scores = score(some_runs());
  ASSERT_EQ(scores.size(), 3U);
  EXPECT_EQ(scores[0].group, "a.maz");
  EXPECT_EQ(scores[0].runs, 3U);
  EXPECT_EQ(scores[0].successes, 2U);
  EXPECT_EQ(scores[0].failures.at("time limit"), 1U);
  EXPECT_THAT(scores[0].values.at("time"), ElementsAre(2.0, 3.0)) << "of successes, in order";
  EXPECT_THAT(scores[0].values.at("collisions"), ElementsAre(1.0, 0.0, 4.0)) << "of all";
  EXPECT_TRUE(scores[0].all_alike);
  EXPECT_EQ(scores[1].group, "/v/b.maz") << "the file's name alone is that of two worlds";
  EXPECT_FALSE(scores[1].all_alike) << "one run";
  EXPECT_EQ(scores[2].group, "all");
  EXPECT_EQ(scores[2].rate(), 0.75);
}

TEST(Assessment, IsATableForPeople) {
  const std::string table = assessment_table(score(some_runs()));
  EXPECT_THAT(table, StartsWith("a.maz: 2 of 3 runs succeed, 66.7 % (20.8 ... 93.9 %), 1 time "
                                "limit; all runs are the same: the seed changes nothing\n"));
  EXPECT_THAT(table,
              HasSubstr("  time, s                   2.5            2            3      2\n"));
}

TEST(Assessment, IsTablesForPrograms) {
  const std::string runs = runs_csv(some_runs());
  EXPECT_THAT(runs, StartsWith("group,seed,success,verdict,reason,time_s,path_m,collisions,"
                               "coverage,agreement,observed,end_x_m,end_y_m,goal_distance_m,"
                               "state_hash,score\na.maz,1,1,success,,2,,1,,,,,,,00000000000000ff,\n"
                               "a.maz,2,1,success,,3,,0,,,,,,,00000000000000ff,0.5\n"));
  EXPECT_THAT(summary_csv(score(some_runs())), HasSubstr("\nall,4,3,0.75,"));
  std::vector<AssessedRun> quoted = some_runs();
  quoted[0].reason = "a \"b\", c";
  EXPECT_THAT(runs_csv(quoted), HasSubstr(",\"a \"\"b\"\", c\",")) << "RFC 4180";
}

TEST(Assessment, DrawsWhatThereIs) {
  const testing::ScratchFolder folder;
  const std::string old = folder.write("coverage.png", "of an earlier assessment");
  plot_assessment(score(some_runs()), folder.path());
  for (const char* name : {"success.png", "time_s.png", "collisions.png"}) {
    EXPECT_EQ(testing::file_text(folder.path() + "/" + name).substr(1, 3), "PNG") << name;
  }
  EXPECT_FALSE(std::filesystem::exists(old));
}

}  // namespace
}  // namespace eyebridge::apps
