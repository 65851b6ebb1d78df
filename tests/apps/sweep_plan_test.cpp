// The matrix of a sweep: axes, cells, and the file that says them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sweep/plan.hpp"
#include "sweep/sweep_file.hpp"

namespace eyebridge::apps {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;

/// What reading `text` as s.toml, and making its cells, is refused with.
std::string refusal(const std::string& text) {
  try {
    cells_of(read_sweep(text, "s.toml"));
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

std::vector<std::string> texts(const std::vector<AxisValue>& values) {
  std::vector<std::string> out;
  for (const AxisValue& value : values) out.push_back(value.text);
  return out;
}

TEST(SweepPlan, EveryCombinationIsACellTheSeedVariesFastest) {
  const SweepPlan plan = read_sweep(
      "program = ['/bin/a', '/bin/b']\n"
      "seed = '1..2'\n"
      "world = '/w/x.wld'\n"
      "arguments = ['--keep', '{keep}']\n"
      "[parameters]\nkeep = [100, 0.5]\n"
      "[environment]\nMODE = 'quick'\n",
      "s.toml");
  const std::vector<Cell> cells = cells_of(plan);
  ASSERT_EQ(cells.size(), 8U);
  EXPECT_EQ(cells[0].settings.at("seed"), "1");
  EXPECT_EQ(cells[1].settings.at("seed"), "2");
  EXPECT_EQ(cells[0].program, "/bin/a");
  EXPECT_EQ(cells[7].program, "/bin/b");
  EXPECT_THAT(cells[0].arguments, ElementsAre("--keep", "100"));
  EXPECT_THAT(cells[2].arguments, ElementsAre("--keep", "0.5"));
  EXPECT_THAT(cells[0].environment, ElementsAre(Pair("MODE", "quick")));
  EXPECT_THAT(cells[0].coordinates(),
              ElementsAre(Pair("program", "/bin/a"), Pair("$MODE", "quick"), Pair("keep", "100"),
                          Pair("seed", "1"), Pair("world", "/w/x.wld")));
}

TEST(SweepPlan, CellsHaveKeysOfTheirOwn) {
  Cell a{"p", {"x"}, {{"seed", "1"}}, {}, {}};
  Cell b = a;
  EXPECT_EQ(a.key(), b.key());
  b.arguments = {"x\ny"};
  a.arguments = {"x", "y"};
  EXPECT_NE(a.key(), b.key()) << "a line end within an argument";
}

TEST(SweepPlan, ARangeHasBothItsEnds) {
  EXPECT_THAT(texts(read_range("3..5", {"--seed"})), ElementsAre("3", "4", "5"));
  EXPECT_THAT(texts(read_range("7", {"--seed"})), ElementsAre("7"));
  for (const char* bad : {"", "..", "1..", "5..3", "a..b", "-1..2", "1...3", "1..99999999999"}) {
    EXPECT_THROW(read_range(bad, {"--seed"}), ConfigError) << bad;
  }
}

TEST(SweepFile, TakesEverythingThatItDocuments) {
  const SweepPlan plan = read_sweep(
      "program = 'follower'\nresults = 'r.db'\nwall_limit = '3s'\njobs = 2\nfast = true\n"
      "time_limit = ['5s', 10]\narguments = ['-v', 3]\n",
      "folder/s.toml");
  EXPECT_EQ(plan.results, "folder/r.db");
  EXPECT_EQ(plan.wall_limit, 3.0);
  EXPECT_EQ(plan.jobs, 2);
  EXPECT_THAT(texts(plan.arguments), ElementsAre("-v", "3"));
  EXPECT_EQ(cells_of(plan).size(), 2U);
}

TEST(SweepFile, TakesRelativePathsFromItsFolder) {
  SweepPlan plan = read_sweep("program = ['../p', 'in-path']\nworld = 'a.wld'\n", "f/s.toml");
  EXPECT_THAT(texts(plan.find(AxisKind::Program, "program")->values),
              ElementsAre("f/../p", "in-path"));
  EXPECT_THAT(texts(plan.find(AxisKind::Setting, "world")->values), ElementsAre("f/a.wld"));
  plan = read_sweep("program = './p'\n", "s.toml");
  EXPECT_EQ(plan.find(AxisKind::Program, "program")->values[0].text, "./p");
}

TEST(SweepFile, RefusesWithThePlace) {
  EXPECT_THAT(refusal("program = 'p'\n\nsead = 3\n"),
              HasSubstr("s.toml:3:1: unknown key 'sead', the nearest setting is 'seed'"));
  EXPECT_EQ(refusal("program = 'p'\nseed = [1, 'x']\n"),
            "s.toml:2:12: found a text for 'seed', expected a whole number");
  EXPECT_EQ(refusal("program = 'p'\nseed = '5..1'\n"),
            "s.toml:2:8: found '5..1', expected a range that goes up, of at most 1000000");
  EXPECT_EQ(refusal("program = 3\n"),
            "s.toml:1:11: found a whole number, expected a text in quotes");
  EXPECT_EQ(refusal("program = []\n"),
            "s.toml:1:11: found an empty list, expected at least one value");
  EXPECT_EQ(refusal("program = 'p'\njobs = 5000\n"),
            "s.toml:2:8: found '5000', expected 0 ... 1024 runs at a time (0: one a core)");
  EXPECT_EQ(refusal("program = 'p'\nparameters = 3\n"),
            "s.toml:2:14: found a whole number, expected a table");
  EXPECT_EQ(refusal("program = 'p'\n[environment]\nEYEBRIDGE_SEED = 3\n"),
            "s.toml:3:1: found EYEBRIDGE_SEED, expected the setting itself");
  EXPECT_EQ(refusal("program = 'p'\n[parameters]\nkeep = [[1]]\n"),
            "s.toml:3:9: found a list, expected a text, a number, true or false");
  EXPECT_THAT(refusal("program = 'p'\nout = 'o'\n"), HasSubstr("s.toml:2:1: found 'out'"));
  EXPECT_THAT(refusal("program = 'p\n"), HasSubstr("s.toml:1:"));
  EXPECT_THAT(refusal("wall_limit = 'x'\n"), HasSubstr("s.toml:1:14: "));
}

TEST(SweepFile, RefusesAMatrixThatMakesNoSense) {
  EXPECT_THAT(refusal("seed = 3\n"), HasSubstr("found no program"));
  EXPECT_EQ(refusal("program = 'p'\narguments = ['{kep}']\n[parameters]\nkeep = 1\n"),
            "s.toml:2:14: found {'kep'}, expected the name of a parameter");
  EXPECT_EQ(refusal("program = 'p'\n[parameters]\nkeep = 1\n"),
            "s.toml:3:8: the parameter 'keep' is not used, expected {keep} in an argument");
  EXPECT_THAT(refusal("program = 'p'\nseed = 1\narguments = ['{seed}']\n[parameters]\nseed = 1\n"),
              HasSubstr("which is another axis, too"));
  EXPECT_THAT(refusal("program = 'p'\nseed = '1..1000000'\nworld = ['a', 'b']\n"),
              HasSubstr("found more than 1000000 runs"));
}

TEST(SweepFile, LeavesBracesAloneThatAreNotClosed) {
  const auto cells = cells_of(read_sweep("program = 'p'\narguments = ['a{b']\n", "s.toml"));
  EXPECT_THAT(cells.at(0).arguments, ElementsAre("a{b"));
}

}  // namespace
}  // namespace eyebridge::apps
