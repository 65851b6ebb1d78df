// What a folder that came from somewhere may make EyeBridge do: nothing that starts programs or
// writes files, until its user has said so (docs/security.md).
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "command.hpp"

namespace eyebridge {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::ProgramRun;
using testing::ScratchFolder;

class TrustCommand : public ::testing::Test {
 protected:
  TrustCommand() {
    std::filesystem::create_directory(folder_.path() + "/came");
    std::filesystem::create_directory(folder_.path() + "/mine");
    std::filesystem::copy_file(EYEBRIDGE_SQUARE, folder_.path() + "/came/square");
    std::filesystem::create_directory(folder_.path() + "/home");
    (void)folder_.write("home/.bashrc", "# mine\n");
    (void)folder_.write("came/room.wld", "floor 2000 2000\n");
    program("mine/evil", "#!/bin/sh\ntouch ran\n");
  }

  void program(const std::string& name, const std::string& text) {
    chmod(folder_.write(name, text).c_str(), 0755);
  }
  /// `eyebridge WORDS` in the folder that came.
  ProgramRun eyebridge(const std::vector<std::string>& words) {
    return testing::run_command(words, folder_.path() + "/came",
                                {{"XDG_DATA_HOME", folder_.path() + "/data"},
                                 {"EYEBRIDGE_FAST", "true"},
                                 {"EYEBRIDGE_TIME_LIMIT", "1s"}});
  }
  /// `./square` there.
  ProgramRun square(std::map<std::string, std::string> environment = {}) {
    environment.emplace("XDG_DATA_HOME", folder_.path() + "/data");
    environment.emplace("XDG_CONFIG_HOME", folder_.path() + "/config");
    environment.emplace("EYEBRIDGE_FAST", "true");
    return testing::run_program({{"./square"}, environment, folder_.path() + "/came"});
  }
  bool is_there(const std::string& name) {
    return std::filesystem::exists(folder_.path() + "/" + name);
  }
  /// Nothing ran, and the message says what to do.
  void expect_refused(const ProgramRun& r, const std::string& what, const std::string& how) {
    EXPECT_EQ(r.exit_code, 2) << r.out;
    EXPECT_THAT(r.err, AllOf(HasSubstr(what), HasSubstr(how)));
    EXPECT_FALSE(is_there("came/ran"));
    EXPECT_EQ(testing::file_text(folder_.path() + "/home/.bashrc"), "# mine\n");
  }

  ScratchFolder folder_;
};

TEST_F(TrustCommand, AFoldersFileWritesAndStartsNothingByItself) {
  for (const char* line :
       {"record = '../home/.bashrc'", "report = '../home/.bashrc'", "out = '../home/new'",
        "player = '/bin/sh -c ls'", "player = '../mine/evil'"}) {
    (void)folder_.write("came/eyebridge.toml", std::string("seed = 2\n") + line + "\n");
    expect_refused(square(), "eyebridge.toml:2:", "'eyebridge trust eyebridge.toml'");
    expect_refused(eyebridge({"run", "square"}), "eyebridge.toml:2:", "or give --");
  }
  EXPECT_FALSE(is_there("home/new"));
}

TEST_F(TrustCommand, OfSettingsThatHaveNoEffectNobodyIsAsked) {
  (void)folder_.write("came/eyebridge.toml",
                      "seed = 2\nplayer = 'none'\nout = ''\nworld = 'room.wld'\n");
  EXPECT_EQ(square().exit_code, 0);
}

TEST_F(TrustCommand, WhatTheUserSaysCounts) {
  (void)folder_.write("came/eyebridge.toml", "report = '../home/.bashrc'\n");
  const ProgramRun r = eyebridge({"run", "--report", "mine.txt", "square"});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_TRUE(is_there("came/mine.txt"));
  EXPECT_EQ(square({{"EYEBRIDGE_REPORT", "variable.txt"}}).exit_code, 0);
  EXPECT_TRUE(is_there("came/variable.txt"));
  std::filesystem::remove(folder_.path() + "/came/eyebridge.toml");
  std::filesystem::create_directories(folder_.path() + "/config/eyebridge");
  (void)folder_.write("config/eyebridge/eyebridge.toml",
                      "report = '" + folder_.path() + "/own.txt'\n");
  EXPECT_EQ(square().exit_code, 0);
  EXPECT_TRUE(is_there("own.txt"));
}

TEST_F(TrustCommand, TrustIsForTheseWordsOfThisFile) {
  (void)folder_.write("came/eyebridge.toml", "report = 'report.txt'\nseed = 3\n");
  const ProgramRun trusted = eyebridge({"trust"});
  EXPECT_EQ(trusted.exit_code, 0) << trusted.err;
  EXPECT_THAT(trusted.out, HasSubstr("report = " + folder_.path() + "/came/report.txt"));
  EXPECT_EQ(square().exit_code, 0);
  EXPECT_TRUE(is_there("came/report.txt"));
  // Other settings may change,
  (void)folder_.write("came/eyebridge.toml", "seed = 4\nreport = 'report.txt'\n");
  EXPECT_EQ(square().exit_code, 0);
  // those that write may not.
  (void)folder_.write("came/eyebridge.toml", "report = '../home/.bashrc'\n");
  expect_refused(square(), "report = ", "eyebridge trust");
  // Nor does another file's trust count.
  std::filesystem::create_directory(folder_.path() + "/came/deeper");
  std::filesystem::copy_file(EYEBRIDGE_SQUARE, folder_.path() + "/came/deeper/square");
  (void)folder_.write("came/deeper/eyebridge.toml", "report = '../report.txt'\n");
  EXPECT_EQ(eyebridge({"run", "deeper/square"}).exit_code, 2);
}

TEST_F(TrustCommand, ListsAndTakesBack) {
  (void)folder_.write("came/eyebridge.toml", "report = 'report.txt'\n");
  EXPECT_EQ(eyebridge({"trust"}).exit_code, 0);
  EXPECT_THAT(eyebridge({"trust", "--list"}).out,
              AllOf(HasSubstr("/came/eyebridge.toml"), HasSubstr("report = ")));
  EXPECT_EQ(eyebridge({"trust", "--revoke"}).exit_code, 0);
  EXPECT_EQ(eyebridge({"trust", "--list"}).out, "");
  EXPECT_EQ(square().exit_code, 2);
  EXPECT_EQ(eyebridge({"trust", "--revoke"}).exit_code, 2) << "there is nothing left";
  EXPECT_EQ(eyebridge({"trust", "nowhere"}).exit_code, 2);
  EXPECT_EQ(eyebridge({"trust", "room.wld"}).exit_code, 2);
}

TEST_F(TrustCommand, ScenariosStartOnlyProgramsOfTheirFolder) {
  std::filesystem::create_symlink("../mine/evil", folder_.path() + "/came/innocent");
  for (const char* program : {"../mine/evil", "/bin/sh ../mine/evil", "innocent"}) {
    (void)folder_.write("came/all.sim", std::string("world room.wld\nS4 500 500 0 square\n") +
                                            "S4 1500 1500 0 " + program + "\n");
    expect_refused(eyebridge({"run", "--world", "all.sim"}), "outside of this file's folder",
                   "'eyebridge trust all.sim'");
    (void)folder_.write("came/all.sim", std::string("world room.wld\nS4 500 500 0 square\n") +
                                            "S4 1500 1500 0 " + program + "\nenters 0.5\n");
    expect_refused(eyebridge({"run", "--world", "all.sim"}), "outside of this file's folder",
                   "'eyebridge trust all.sim'");
  }
  (void)folder_.write("came/all.sim",
                      "world room.wld\nS4 500 500 0 square\nS4 1500 1500 0 innocent\n");
  EXPECT_EQ(eyebridge({"trust", "."}).exit_code, 0);
  EXPECT_EQ(eyebridge({"run", "--world", "all.sim"}).exit_code, 0);
  EXPECT_TRUE(is_there("came/ran"));
}

TEST_F(TrustCommand, AFoldersFileNamesNoOtherFoldersPrograms) {
  (void)folder_.write("mine/own.sim", "world ../came/room.wld\nS4 500 500 0 evil\n");
  (void)folder_.write("came/eyebridge.toml", "world = '../mine/own.sim'\n");
  expect_refused(eyebridge({"run"}), "eyebridge.toml:1:9: found", "expected --world");
}

TEST_F(TrustCommand, ASweepDoesNotRemoveWhatALinkLeadsTo) {
  std::filesystem::create_directories(folder_.path() + "/mine/1");
  std::filesystem::create_symlink("../mine", folder_.path() + "/came/sweep.db.runs");
  EXPECT_EQ(eyebridge({"sweep", "./square"}).exit_code, 2);
  EXPECT_TRUE(is_there("mine/1"));
}

TEST_F(TrustCommand, SweepFilesStartOnlyProgramsOfTheirFolder) {
  (void)folder_.write("came/sweep.toml", "program = '../mine/evil'\nseed = '1..2'\n");
  expect_refused(eyebridge({"sweep", "sweep.toml"}),
                 "sweep.toml:1:", "'eyebridge trust sweep.toml'");
  (void)folder_.write("came/sweep.toml", "program = './square'\nplayer = ['none', '/bin/sh x']\n");
  expect_refused(eyebridge({"sweep", "sweep.toml"}), "sweep.toml:2:", "eyebridge trust");
  EXPECT_EQ(eyebridge({"trust", "sweep.toml"}).exit_code, 0);
  EXPECT_EQ(eyebridge({"sweep", "sweep.toml"}).exit_code, 0);
}

TEST_F(TrustCommand, OfASweepFileIsForAllThatItHandsOver) {
  const std::string begin = "program = '/bin/sh'\nseed = 1\n";
  (void)folder_.write("came/sweep.toml", begin + "arguments = ['-c', 'true']\n");
  const ProgramRun given = eyebridge({"trust", "sweep.toml"});
  EXPECT_EQ(given.exit_code, 0) << given.err;
  EXPECT_THAT(given.out, HasSubstr(R"( "-c" "true")"));
  EXPECT_NE(eyebridge({"sweep", "sweep.toml"}).exit_code, 2);
  (void)folder_.write("came/sweep.toml", begin + "arguments = ['-c', 'touch ../../ran']\n");
  expect_refused(eyebridge({"sweep", "sweep.toml"}), "touch", "eyebridge trust sweep.toml");
  (void)folder_.write("came/sweep.toml", begin +
                                             "arguments = ['-c', 'true']\n"
                                             "[environment]\nLD_PRELOAD = './x.so'\n");
  expect_refused(eyebridge({"sweep", "sweep.toml"}), "LD_PRELOAD=", "eyebridge trust");
}

TEST_F(TrustCommand, SweepFilesKeepTheirResultsInTheirFolder) {
  for (const char* results : {"../home/other.db", "../home/.bashrc", "/tmp/other.db"}) {
    (void)folder_.write("came/sweep.toml",
                        std::string("program = './square'\nresults = '") + results + "'\n");
    expect_refused(eyebridge({"sweep", "sweep.toml"}), "sweep.toml:2:", "--results");
  }
  EXPECT_FALSE(is_there("home/other.db"));
}

// SQLite removes the file that a journal names, before anybody has looked at what it is.
TEST_F(TrustCommand, NoJournalBesideResultsIsPlayedBack) {
  EXPECT_EQ(eyebridge({"sweep", "--seed", "1", "./square"}).exit_code, 0);
  (void)folder_.write("came/sweep.db-journal", "anything");
  const ProgramRun r = eyebridge({"sweep", "--seed", "1", "./square"});
  EXPECT_EQ(r.exit_code, 2);
  EXPECT_THAT(r.err, HasSubstr("sweep.db-journal beside it"));
  EXPECT_TRUE(is_there("came/sweep.db-journal"));
}

TEST_F(TrustCommand, HoldsForWhereALinkLedThen) {
  std::filesystem::create_directory(folder_.path() + "/came/own");
  std::filesystem::create_directory_symlink("own", folder_.path() + "/came/res");
  (void)folder_.write("came/eyebridge.toml", "out = 'res'\n");
  EXPECT_EQ(eyebridge({"trust"}).exit_code, 0);
  EXPECT_EQ(square().exit_code, 0);
  std::filesystem::remove(folder_.path() + "/came/res");
  std::filesystem::create_directory_symlink("../home", folder_.path() + "/came/res");
  expect_refused(square(), "out = ", "eyebridge trust");
  EXPECT_FALSE(is_there("home/lcd.txt"));
}

TEST_F(TrustCommand, APlayerWithASlashLiesInTheFilesFolder) {
  (void)folder_.write("came/eyebridge.toml", "player = './beep --loud'\n");
  const ProgramRun given = eyebridge({"trust"});
  EXPECT_THAT(given.out, HasSubstr("player = " + folder_.path() + "/came/beep --loud"));
}

TEST_F(TrustCommand, IsListedALineEach) {
  (void)folder_.write("came/eyebridge.toml", "player = \"aplay\\n/home/you/eyebridge.toml\"\n");
  EXPECT_EQ(eyebridge({"trust"}).exit_code, 0);
  EXPECT_THAT(eyebridge({"trust", "--list"}).out,
              HasSubstr("  player = aplay\\n/home/you/eyebridge.toml\n"));
  std::filesystem::remove_all(folder_.path() + "/came");
  std::filesystem::create_directory(folder_.path() + "/came");
  EXPECT_EQ(eyebridge({"trust", "--revoke", "../came"}).exit_code, 0) << "though it is gone";
  EXPECT_EQ(eyebridge({"trust", "--list"}).out, "");
}

// Both wrote into one trace.
TEST_F(TrustCommand, WhatAProgramStartsDoesNotWriteIntoItsResults) {
  (void)folder_.write("came/twice.c",
                      "#include <stdlib.h>\n#include <eyebot.h>\nint main(void) {\n"
                      "  VWStraight(100, 100);\n  OSWait(200);\n"
                      "  return system(\"./square >/dev/null\");\n}\n");
  const ProgramRun built = testing::run_program(
      {{EYEBRIDGE_BIN "/eyebridge-cc", "twice.c", "-o", "twice"}, {}, folder_.path() + "/came"});
  ASSERT_EQ(built.exit_code, 0) << built.err;
  (void)folder_.write("came/eyebridge.toml", "out = 'out'\nreport = 'report.txt'\n");
  EXPECT_EQ(eyebridge({"trust"}).exit_code, 0);
  const ProgramRun r = eyebridge({"run", "./twice"});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  const std::size_t first = r.err.find("results in");
  EXPECT_NE(first, std::string::npos) << r.err;
  EXPECT_EQ(r.err.find("results in", first + 1), std::string::npos) << r.err;
}

TEST_F(TrustCommand, ResultsThatAreRemovedDuringTheRunAreMissed) {
  (void)folder_.write(
      "came/removes.c",
      "#include <stdlib.h>\n#include <eyebot.h>\nint main(int argc, char** argv) {\n"
      "  VWStraight(100, 100);\n  OSWait(200);\n"
      "  return argc == 2 ? system(argv[1]) : 1;\n}\n");
  const ProgramRun built =
      testing::run_program({{EYEBRIDGE_BIN "/eyebridge-cc", "removes.c", "-o", "removes"},
                            {},
                            folder_.path() + "/came"});
  ASSERT_EQ(built.exit_code, 0) << built.err;
  for (const char* flag : {"--report", "--record", "--out"}) {
    const ProgramRun r = eyebridge({"run", flag, "result", "./removes", "rm -r result*"});
    EXPECT_EQ(r.exit_code, 1) << flag << r.err;
    EXPECT_THAT(r.err, HasSubstr("it was removed during the run")) << flag;
  }
}

TEST_F(TrustCommand, APictureThatNobodyNamedReplacesNothing) {
  std::filesystem::create_symlink("../home/.bashrc", folder_.path() + "/came/room.png");
  EXPECT_EQ(eyebridge({"world", "draw", "room.wld"}).exit_code, 0);
  EXPECT_EQ(testing::file_text(folder_.path() + "/home/.bashrc"), "# mine\n");
  const ProgramRun named = eyebridge({"world", "draw", "room.wld", "-o", "../home/.bashrc"});
  EXPECT_NE(named.exit_code, 0);
  EXPECT_THAT(named.err, HasSubstr("another kind of file"));
  EXPECT_EQ(testing::file_text(folder_.path() + "/home/.bashrc"), "# mine\n");
}

TEST_F(TrustCommand, APipeInThePlaceOfAProgramIsNotWaitedFor) {
  ASSERT_EQ(mkfifo((folder_.path() + "/came/f.py").c_str(), 0600), 0);
  const ProgramRun r = eyebridge({"run", "f.py"});
  EXPECT_NE(r.exit_code, 0);
  EXPECT_THAT(r.err, HasSubstr("found no regular file"));
}

}  // namespace
}  // namespace eyebridge
