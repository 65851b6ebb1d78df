// What a sweep keeps, counts and draws.

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/base/config_error.hpp"
#include "run_program.hpp"
#include "sweep/outcome.hpp"
#include "sweep/plot.hpp"
#include "sweep/progress.hpp"
#include "sweep/results.hpp"
#include "sweep/summary.hpp"

namespace eyebridge::apps {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;
using testing::ScratchFolder;

Cell cell(const std::string& seed, const std::string& keep = "1") {
  return {"/bin/p", {"{keep}"}, {{"seed", seed}}, {}, {{"keep", keep}}};
}

Outcome outcome(double time) {
  Outcome o;
  o.how = "ended";
  o.exit_code = 0;
  o.time = time;
  o.distance = time / 2;
  o.collisions = 1;
  o.state_hash = "0123456789abcdef";
  o.results = {{"score", "2.5"}, {"word", "good"}};
  return o;
}

TEST(Outcome, ReadsReportAndResults) {
  const ScratchFolder folder;
  const std::string report = folder.write(
      "r",
      "time =  12.500000\ndistance = 3.0\ncollisions =  2\nstate_hash = \"00000000000000ff\"\n"
      "ended = true \nend_x =  -1.250000\nb =  7.000000\n");
  const std::string output = folder.write(
      "o",
      "hello\nresult a 1\nresult b two words \nresult a 2\nresult\nresult c\nresult d/e 3\n"
      "results x 1\nresult f a\tb");
  Outcome o;
  read_files(o, report, output);
  EXPECT_EQ(o.time, 12.5);
  EXPECT_EQ(o.distance, 3.0);
  EXPECT_EQ(o.collisions, 2U);
  EXPECT_EQ(o.state_hash, "00000000000000ff");
  EXPECT_THAT(o.results,
              ElementsAre(Pair("end_x", "-1.250000"), Pair("b", "7.000000"), Pair("a", "2"),
                          Pair("result.b", "two words"), Pair("f", "a?b")));
}

TEST(Outcome, InventsNothingThatTheFilesDoNotSay) {
  const ScratchFolder folder;
  Outcome o;
  read_files(o, folder.path() + "/none", folder.path() + "/none");
  EXPECT_FALSE(o.time || o.distance || o.collisions);
  const std::string cut =
      folder.write("r", "time = 1.0\nstate_hash = \"00000000000000ff\"\nended = false\n");
  read_files(o, cut, folder.path() + "/none");
  EXPECT_EQ(o.time, 1.0);
  EXPECT_EQ(o.state_hash, "") << "it did not end by itself";
}

TEST(Outcome, TravelsAsText) {
  Outcome o = outcome(0.1);
  o.how = "crashed";
  o.reason = "SIGSEGV: line\twith = signs";
  o.exit_code.reset();
  o.signal = SIGSEGV;
  o.wall = 1.0 / 3;
  const Outcome again = outcome_from_text(to_text(o));
  EXPECT_EQ(to_text(again), to_text(o));
  EXPECT_EQ(again.wall, o.wall);
  EXPECT_EQ(again.results, o.results);
  EXPECT_EQ(again.reason, o.reason);
  EXPECT_THROW(outcome_from_text("ended"), std::runtime_error);
  EXPECT_THROW(outcome_from_text(""), std::runtime_error);
}

TEST(Outcome, NamesSignals) {
  EXPECT_EQ(signal_name(SIGSEGV), "SIGSEGV");
  EXPECT_EQ(signal_name(60), "signal 60");
}

TEST(ResultsFile, KeepsWhatIsAdded) {
  const ScratchFolder folder;
  const std::string file = folder.path() + "/r.db";
  {
    ResultsFile results(file);
    results.add(cell("1"), outcome(2));
    Outcome bad;
    bad.how = "crashed";
    results.add(cell("2"), bad);
    EXPECT_EQ(results.keys(false).size(), 2U);
    EXPECT_EQ(results.keys(true), std::set{cell("1").key()});
    results.add(cell("2"), outcome(4));
  }
  const std::vector<ResultRow> rows = read_results_file(file);
  ASSERT_EQ(rows.size(), 2U) << "a run that is tried again takes the place of the first";
  EXPECT_EQ(rows[1].how, "ended");
  EXPECT_EQ(rows[0].coordinates.at("seed"), "1");
  EXPECT_EQ(rows[0].coordinates.at("keep"), "1");
  EXPECT_EQ(rows[0].values.at("score"), 2.5);
  EXPECT_EQ(rows[0].values.at("time"), 2.0);
  EXPECT_FALSE(rows[0].values.contains("word")) << "no number";
  EXPECT_FALSE(std::filesystem::exists(file + "-journal")) << "one file";
}

TEST(ResultsFile, TellsAProgramsNumbersFromItsOwn) {
  const ScratchFolder folder;
  Outcome o = outcome(2);
  o.results = {{"time", "99"}};
  ResultsFile(folder.path() + "/r.db").add(cell("1"), o);
  const auto values = read_results_file(folder.path() + "/r.db").at(0).values;
  EXPECT_EQ(values.at("time"), 2.0);
  EXPECT_EQ(values.at("result.time"), 99.0);
}

TEST(ResultsFile, IsWrittenByOneSweepAtATime) {
  const ScratchFolder folder;
  const std::string file = folder.path() + "/r.db";
  const ResultsFile first(file);
  EXPECT_THROW(
      {
        try {
          const ResultsFile second(file);
        } catch (const ConfigError& error) {
          EXPECT_THAT(error.what(), HasSubstr("another sweep is writing it"));
          throw;
        }
      },
      ConfigError);
  EXPECT_TRUE(read_results_file(file).empty()) << "looking is fine";
}

TEST(ResultsFile, RefusesOtherFiles) {
  const ScratchFolder folder;
  const std::string text = folder.write("notes.txt", "these are my notes, and no database at all");
  EXPECT_THROW(ResultsFile{text}, ConfigError);
  EXPECT_EQ(testing::file_text(text), "these are my notes, and no database at all");
  EXPECT_THROW(ResultsFile{folder.path() + "/no/folder.db"}, ConfigError);
  EXPECT_THROW(read_results_file(folder.path() + "/gone.db"), ConfigError);
  EXPECT_THROW(read_results_file(text), ConfigError);
}

TEST(ResultsFile, LeavesDatabasesOfOthersAsTheyAre) {
  const ScratchFolder folder;
  const std::string file = folder.path() + "/mine.db";
  {
    const auto database = camera::sqlite::Database([&] {
      sqlite3* opened = nullptr;
      EXPECT_EQ(sqlite3_open(file.c_str(), &opened), SQLITE_OK);
      return opened;
    }());
    camera::sqlite::run(database.get(), "CREATE TABLE mine(x)");
  }
  const std::string before = testing::file_text(file);
  EXPECT_THROW(ResultsFile{file}, ConfigError);
  EXPECT_EQ(testing::file_text(file), before);
}

TEST(ResultsFile, RefusesRunsOfAnotherVersionOfAProgram) {
  const ScratchFolder folder;
  const std::string program = folder.write("prog", "one");
  const std::string file = folder.path() + "/r.db";
  ResultsFile(file).note_input(program);
  ResultsFile(file).note_input(program);
  folder.write("prog", "two");
  EXPECT_THROW(ResultsFile(file).note_input(program), ConfigError);
}

TEST(Spread, IsThatOfTheNumbers) {
  Spread s;
  for (const double value : {2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0}) s.add(value);
  EXPECT_DOUBLE_EQ(s.mean, 5.0);
  EXPECT_NEAR(s.deviation, 2.13809, 1e-5) << "of a sample: root of 32 / 7";
  EXPECT_EQ(s.least, 2.0);
  EXPECT_EQ(s.most, 9.0);
  Spread one;
  one.add(-3);
  EXPECT_EQ(one.deviation, 0.0);
  EXPECT_EQ(one.most, -3.0);
}

std::vector<ResultRow> rows() {
  const auto row = [](const char* keep, const char* seed, const char* how, double time) {
    ResultRow out;
    out.coordinates = {{"keep", keep}, {"seed", seed}, {"world", "/a/x.wld"}};
    out.how = how;
    out.values = {{"time", time}};
    return out;
  };
  return {row("1", "1", "ended", 1.0), row("2", "1", "ended", 5.0),
          row("1", "2", "time limit", 3.0), row("2", "2", "crashed", 100.0)};
}

TEST(Summary, GroupsByAllThatDiffersButTheSeed) {
  const std::vector<Group> groups = group_runs(rows(), {});
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].label, "keep=1");
  EXPECT_EQ(groups[0].spread("time").mean, 2.0);
  EXPECT_EQ(groups[1].spread("time").mean, 5.0) << "what went wrong does not count";
  EXPECT_EQ(groups[1].ends.at("crashed"), 1U);
}

TEST(Summary, GroupsByWhatIsAskedFor) {
  const std::vector<Group> groups = group_runs(rows(), {"world", "seed"});
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].label, "world=x.wld seed=1");
  EXPECT_THROW(group_runs(rows(), {"kep"}), ConfigError);
  EXPECT_EQ(group_runs({rows()[0]}, {})[0].label, "all runs");
}

TEST(Summary, IsATable) {
  const std::string table = summary_table(group_runs(rows(), {}));
  EXPECT_THAT(table, HasSubstr("keep=1: 2 runs, 1 ended, 1 time limit\n"));
  EXPECT_THAT(table, HasSubstr("keep=2: 2 runs, 1 crashed, 1 ended\n"));
  EXPECT_THAT(table, HasSubstr("  time                        2       1.4142            1"
                               "            3\n"));
}

TEST(Plot, DrawsAPicture) {
  const ScratchFolder folder;
  const std::string file = folder.path() + "/p.png";
  plot(group_runs(rows(), {}), "time", file);
  EXPECT_EQ(testing::file_text(file).substr(1, 3), "PNG");
  EXPECT_THROW(plot(group_runs(rows(), {}), "tim", file), ConfigError);
  EXPECT_THROW(plot(group_runs(rows(), {}), "time", folder.path() + "/no/p.png"),
               std::runtime_error);
}

/// What a Progress over four cells, one of them done before, writes for a good and a bad run.
std::string progress(bool terminal) {
  char* text = nullptr;
  std::size_t size = 0;
  std::FILE* out = open_memstream(&text, &size);
  {
    Progress progress(out, terminal, 4, 1);
    progress.ended(cell("2"), outcome(1), 10.0);
    Outcome bad;
    bad.how = "failed";
    bad.reason = "exit code 3";
    progress.ended(cell("3"), bad, 20.0);
    progress.finish();
  }
  std::fclose(out);
  std::string written(text, size);
  free(text);
  return written;
}

TEST(Progress, IsALineForEachRun) {
  EXPECT_EQ(progress(false),
            "2/4 p keep=1 seed=2: ended\n3/4 p keep=1 seed=3: failed, exit code 3\n");
}

TEST(Progress, IsABarOnATerminal) {
  const std::string bar = progress(true);
  EXPECT_THAT(bar, HasSubstr("\r\x1B[K[===============               ] 2/4, 20 s to go"));
  EXPECT_THAT(bar, HasSubstr("\r\x1B[Kp keep=1 seed=3: failed, exit code 3\n"));
  EXPECT_THAT(bar, HasSubstr("] 3/4, 1 went wrong, 10 s to go\n"));
}

}  // namespace
}  // namespace eyebridge::apps
