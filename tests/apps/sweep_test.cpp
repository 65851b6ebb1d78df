// eyebridge sweep, from outside.

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/camera/recording/sqlite.hpp"
#include "many_runs.hpp"

namespace eyebridge {
namespace {

namespace fs = std::filesystem;
namespace sqlite = camera::sqlite;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::ProgramRun;
using testing::run_command;
using testing::run_shell;

class Sweep : public testing::ManyRuns {
 protected:
  ProgramRun sweep(std::vector<std::string> words) {
    words.insert(words.begin(), "sweep");
    return run_command(words, folder_.path());
  }
  /// The rows that `sql` selects in the results, columns with '|' between, '-' for null.
  std::vector<std::string> select(const std::string& sql) {
    sqlite3* opened = nullptr;
    sqlite3_open_v2((folder_.path() + "/sweep.db").c_str(), &opened, SQLITE_OPEN_READONLY, nullptr);
    const sqlite::Database database(opened);
    const auto row = sqlite::prepare(opened, sql.c_str());
    std::vector<std::string> out;
    while (sqlite::step(row)) {
      std::string line;
      for (int i = 0; i < sqlite3_column_count(row.get()); ++i) {
        line += (i == 0 ? "" : "|") + (sqlite::is_null(row, i) ? "-" : sqlite::text(row, i));
      }
      out.push_back(line);
    }
    return out;
  }

  const std::string cell_ = EYEBRIDGE_TEST_SWEEP_CELL;
  const std::string worlds_ = EYEBRIDGE_SOURCE_DIR "/worlds/";
};

TEST_F(Sweep, RunsTheWholeMatrixAndKeepsWhatCameOfIt) {
  const ProgramRun r =
      sweep({"--seed", "1..2", "--world", worlds_ + "empty-room.wld", "--world",
             worlds_ + "corridor.wld", "--parameter", "ms=500", "--parameter", "ms=1000", "--plot",
             "p.png", "--value", "way", cell_, "drive", "{ms}"});
  ASSERT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.err, HasSubstr("8/8 program_sweep_cell"));
  EXPECT_THAT(r.out, HasSubstr("ms=1000 world=corridor.wld: 2 runs, 2 ended\n"));
  EXPECT_TRUE(fs::exists(folder_.path() + "/p.png"));
  EXPECT_FALSE(fs::exists(folder_.path() + "/sweep.db.runs")) << "nothing went wrong";
  EXPECT_EQ(select("SELECT count(*), count(DISTINCT key), min(exit_code), max(exit_code) FROM run"),
            std::vector<std::string>{"8|8|0|0"});
  EXPECT_EQ(
      select("SELECT count(*) FROM run WHERE time >= 0.5 AND distance > 0.05 AND wall > 0 AND "
             "cpu > 0 AND length(state_hash) = 16 AND collisions = 0"),
      std::vector<std::string>{"8"});
  EXPECT_EQ(select("SELECT count(DISTINCT state_hash) FROM run JOIN coordinate ON run = id WHERE "
                   "name = 'ms' AND value = '500'"),
            std::vector<std::string>{"2"})
      << "without noise the seed changes nothing";
  EXPECT_EQ(select("SELECT DISTINCT value FROM result WHERE name = 'word'"),
            std::vector<std::string>{"two words"});
  EXPECT_EQ(select("SELECT count(*) FROM result WHERE name = 'way' AND typeof(value) = 'real'"),
            std::vector<std::string>{"8"})
      << "the last value of a name";
}

TEST_F(Sweep, AFileSaysWhatIsRunAndFlagsTakeTheirPlaceInIt) {
  folder_.write("my.toml", "program = '" + cell_ +
                               "'\narguments = ['drive', '{ms}']\nseed = '1..5'\n"
                               "time_limit = '400ms'\n[parameters]\nms = [100, 900]\n");
  const auto own = testing::trusted(folder_.path() + "/my.toml", folder_);
  const ProgramRun r =
      testing::run_command({"sweep", "--seed", "3", "my.toml"}, folder_.path(), own);
  ASSERT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(select("SELECT value, how FROM run JOIN coordinate ON run = id WHERE name = 'ms' "
                   "ORDER BY value"),
            (std::vector<std::string>{"100|ended", "900|time limit"}));
  EXPECT_EQ(select("SELECT DISTINCT value FROM coordinate WHERE name = 'seed'"),
            std::vector<std::string>{"3"});
}

TEST_F(Sweep, GivesTheProgramItsEnvironment) {
  write_program("prog", "#!/bin/sh\necho result mode $MODE\n");
  const ProgramRun r = sweep({"--env", "MODE=a", "--env", "MODE=b", "./prog"});
  ASSERT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(select("SELECT c.name, c.value, r.value FROM coordinate c JOIN result r USING(run) "
                   "WHERE c.name = '$MODE' ORDER BY 2"),
            (std::vector<std::string>{"$MODE|a|a", "$MODE|b|b"}));
}

TEST_F(Sweep, WhatGoesWrongIsARowAndTheRestGoesOn) {
  const ProgramRun r =
      sweep({"--wall-limit", "8s", "--parameter", "what=crash", "--parameter", "what=exit",
             "--parameter", "what=hang", "--parameter", "what=nothing", cell_, "{what}", "3"});
  ASSERT_EQ(r.exit_code, 0) << r.err;
  const auto rows = select(
      "SELECT value, how, reason, exit_code, signal, cast(time AS INTEGER), state_hash IS NULL "
      "FROM run JOIN coordinate ON run = id WHERE name = 'what' ORDER BY value");
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0], "crash|crashed|SIGSEGV|-|11|2|1") << "its report is at most a second old";
  EXPECT_EQ(rows[1], "exit|failed|exit code 3: I give up|3|-|2|0");
  EXPECT_THAT(rows[2], HasSubstr("hang|hung|no end after 8 s of real time"));
  EXPECT_EQ(rows[3], "nothing|ended||0|-|-|1") << "it used no robot: nothing is invented";
  EXPECT_TRUE(fs::exists(folder_.path() + "/sweep.db.runs/1/err.txt")) << "it may tell why";
}

TEST_F(Sweep, AProgramThatIsNoneOfThisMachineIsARow) {
  write_program("alien",
                "\x7F"
                "ELF is what it begins with");
  write_program("good", "#!/bin/sh\n");
  folder_.write("s.toml", "program = ['./alien', './good']\n");
  ASSERT_EQ(sweep({"s.toml"}).exit_code, 0);
  const auto rows = select("SELECT how, reason FROM run ORDER BY how");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0], "ended|");
  EXPECT_THAT(rows[1], HasSubstr("failed|exit code 2: eyebridge: "));
}

TEST_F(Sweep, RefusesBeforeTheFirstRunWhatCannotBe) {
  write_program("prog", "#!/bin/sh\ntouch " + folder_.path() + "/started\n");
  folder_.write("plain", "no program");
  const std::string file = folder_.path() + "/s.toml";
  expect_refused(sweep({"./gone"}), "./gone: no such program");
  expect_refused(sweep({"./plain"}), "./plain: not executable");
  expect_refused(sweep({"--world", "gone.wld", "--world", worlds_ + "rooms.wld", "./prog"}),
                 "gone.wld");
  expect_refused(sweep({"--seed", "1..x", "./prog"}), "--seed: found '1..x'");
  expect_refused(sweep({"--robot", "R2D2", "./prog"}), "R2D2");
  expect_refused(sweep({"--parameter", "x", "./prog"}),
                 "--parameter: found 'x', expected NAME=VALUE");
  expect_refused(sweep({"--out", "x", "./prog"}), "--out: found 'out'");
  expect_refused(sweep({}), "found no program");
  expect_refused(sweep({"--flag", "./prog"}), "--flag");
  expect_refused(sweep({"gone.toml"}), "gone.toml: no such sweep file");
  folder_.write("s.toml", "program = ['./prog',\n  './gone']\n");
  expect_refused(sweep({"s.toml"}), "s.toml:2:3: ./gone: no such program");
  folder_.write("s.toml", "program = './prog'\nworld = ['" + worlds_ + "rooms.wld', 'gone.wld']\n");
  expect_refused(sweep({"s.toml"}), "s.toml:2:");
  expect_refused(sweep({"s.toml", "--seed", "3"}), "expected options before it");
}

TEST_F(Sweep, TheSameCommandRunsOnlyWhatIsMissing) {
  write_program("prog", "#!/bin/sh\necho \"$1\" >> " + folder_.path() + "/log\n[ $1 != 2 ]\n");
  const std::string log = folder_.path() + "/log";
  const auto run = [&](std::vector<std::string> words) {
    std::vector<std::string> all = {"--jobs", "1"};
    all.insert(all.end(), words.begin(), words.end());
    for (const char* word : {"./prog", "{n}"}) all.emplace_back(word);
    fs::remove(log);
    EXPECT_EQ(sweep(all).exit_code, 0);
    return fs::exists(log) ? testing::file_text(log) : "";
  };
  EXPECT_EQ(run({"--parameter", "n=1", "--parameter", "n=2"}), "1\n2\n");
  EXPECT_EQ(run({"--parameter", "n=1", "--parameter", "n=2"}), "");
  EXPECT_EQ(run({"--parameter", "n=1", "--parameter", "n=2", "--parameter", "n=3"}), "3\n");
  EXPECT_EQ(run({"--retry", "--parameter", "n=1", "--parameter", "n=2"}), "2\n")
      << "what went wrong, when asked to";
  write_program("prog", "#!/bin/sh\n# another version\n");
  expect_refused(sweep({"--parameter", "n=1", "./prog", "{n}"}), "another version of");
}

/// A program that says on a pipe that it is at its third run, and goes on when it reads from
/// another. That run starts before the second one is stored: it waits until that is said.
constexpr const char* kWaits =
    "#!/bin/sh\necho result n $1\n[ $1 = 3 ] || exit 0\n"
    "cd ../..\nuntil grep -q 2/4 first.txt; do :; done\necho here > reached\nread line < go\n";

constexpr const char* kSweepOfFour =
    "mkfifo reached go\n"
    "sweep='eyebridge sweep --jobs 1 --parameter n=1 --parameter n=2 --parameter n=3 "
    "--parameter n=4 ./prog {n}'\n"
    "$sweep > first.txt 2>&1 &\n"
    "read line < reached\n";

TEST_F(Sweep, KilledInTheMiddleLosesNothingThatEnded) {
  write_program("prog", kWaits);
  const ProgramRun r = run_shell(std::string(kSweepOfFour) +
                                     "kill -KILL $!\nwait || true\n"
                                     "eyebridge sweep --show --by program\n"
                                     "(read line < reached; echo go > go) &\n$sweep\n",
                                 folder_.path());
  ASSERT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("program=prog: 2 runs, 2 ended\n"));
  EXPECT_THAT(r.err, HasSubstr("3/4 prog n=3"));
  EXPECT_THAT(r.err, Not(HasSubstr("1/4 "))) << "the first two were there";
  EXPECT_EQ(select("SELECT count(*) FROM run"), std::vector<std::string>{"4"});
}

TEST_F(Sweep, InterruptedItSaysHowToGoOn) {
  write_program("prog", kWaits);
  const ProgramRun r =
      run_shell(std::string(kSweepOfFour) +
                    "kill -TERM $!\n"
                    "if wait $!; then echo fine; else echo ended with $?; fi\ncat first.txt\n",
                folder_.path());
  EXPECT_THAT(r.out, HasSubstr("ended with 1\n")) << r.err;
  EXPECT_THAT(r.out, HasSubstr("interrupted with 2 of 4 runs in sweep.db"));
  EXPECT_EQ(select("SELECT count(*) FROM run"), std::vector<std::string>{"2"});
}

TEST_F(Sweep, TwoSweepsDoNotWriteOneFile) {
  write_program("prog", kWaits);
  const ProgramRun r = run_shell(std::string(kSweepOfFour) +
                                     "if $sweep; then echo fine; else echo refused with $?; fi\n"
                                     "echo go > go\nwait\ncat first.txt\n",
                                 folder_.path());
  EXPECT_THAT(r.out, HasSubstr("refused with 2\n"));
  EXPECT_THAT(r.err, HasSubstr("sweep.db: another sweep is writing it"));
  EXPECT_THAT(r.out, HasSubstr("4/4 prog n=4")) << "the first goes on";
}

TEST_F(Sweep, SettingsOfThisFolderReachTheRuns) {
  folder_.write("eyebridge.toml", "world = 'here.wld'\ncost_scale = 2\n");
  folder_.write("here.wld", testing::file_text(worlds_ + "empty-room.wld"));
  write_program("prog", "#!/bin/sh\necho \"result flags $(echo $EYEBRIDGE_PLAN)\"\n");
  ASSERT_EQ(sweep({"--seed", "4", "./prog"}).exit_code, 0);
  const std::string flags = select("SELECT value FROM result").at(0);
  EXPECT_THAT(flags, HasSubstr("world=" + folder_.path() + "/here.wld"));
  EXPECT_THAT(flags, HasSubstr("cost_scale=2"));
  EXPECT_THAT(flags, HasSubstr("fast=true"));
  EXPECT_THAT(flags, HasSubstr("seed=4"));
}

TEST_F(Sweep, ShowsWhatIsThereInOtherGroups) {
  ASSERT_EQ(sweep({"--seed", "1..2", cell_, "drive", "500"}).exit_code, 0);
  const ProgramRun r = sweep({"--show", "--by", "seed"});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("seed=1: 1 run, 1 ended\n"));
  EXPECT_EQ(sweep({"--show", "--by", "sede"}).exit_code, 2);
  EXPECT_EQ(sweep({"--show", "--results", "gone.db"}).exit_code, 2);
}

TEST_F(Sweep, ARunTellsOfItselfInAReport) {
  const ProgramRun r =
      run_command({"run", "--fast", "--report", "r.txt", cell_, "drive", "60000"}, folder_.path());
  ASSERT_EQ(r.exit_code, 0) << r.err;
  const std::string report = testing::file_text(folder_.path() + "/r.txt");
  EXPECT_THAT(report, ::testing::MatchesRegex(
                          "time = +60\\.[0-9]+\ndistance = +0\\.[0-9]+\n"
                          "collisions = +1\nstuck = +[0-9.]+\nstate_hash = \"[0-9a-f]+\"\n"
                          "trace_hash = \"[0-9a-f]{16}\"\n"
                          "ended = true \n"
                          "end_x = +[0-9.]+\nend_y = +[0-9.]+\n"
                          "end_theta = +[-0-9.]+\n"));
  const ProgramRun bad =
      run_command({"run", "--fast", "--report", "no/r.txt", cell_}, folder_.path());
  EXPECT_EQ(bad.exit_code, 2);
  EXPECT_THAT(bad.err, HasSubstr("--report: cannot write"));
}

TEST_F(Sweep, WhatUsesNoRobotHasNoReport) {
  write_program("prog", "#!/bin/sh\necho result n 4\n");
  const ProgramRun r = run_command({"run", "--report", "r.txt", "./prog"}, folder_.path());
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_FALSE(fs::exists(folder_.path() + "/r.txt"));
}

}  // namespace
}  // namespace eyebridge
