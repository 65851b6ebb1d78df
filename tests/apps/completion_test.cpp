#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command.hpp"

namespace eyebridge {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::ProgramRun;
using testing::run_command;
using testing::run_shell;
using testing::ScratchFolder;

/// What can come after these words, the last of which is being typed.
std::string after(std::vector<std::string> words) {
  words.insert(words.begin(), {"completion", "words", "--"});
  const ProgramRun r = run_command(words, ".");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  return r.out;
}

TEST(Completion, KnowsSubcommandsOfSubcommands) {
  EXPECT_THAT(after({""}), AllOf(HasSubstr("run\tRuns a robot program"), HasSubstr("camera\t")));
  EXPECT_THAT(after({"camera", "mar"}), ContainsRegex("^markers\t[^\n]+\n$"));
}

TEST(Completion, KnowsOptionsButNotOfThePrograms) {
  EXPECT_THAT(after({"run", "--wor"}), ContainsRegex("^--world\t[^\n]+\n$"));
  EXPECT_THAT(after({"run", "--fast", "--wor"}), HasSubstr("--world"));
  EXPECT_EQ(after({"run", "prog", "--wor"}), "files\n");
  EXPECT_EQ(after({"lab", "--", "--viv"}), "files\n");
}

TEST(Completion, KnowsWhatValuesAnOptionTakes) {
  EXPECT_EQ(after({"run", "--gui=o"}), "--gui=on\t\n--gui=off\t\n");
  EXPECT_EQ(after({"run", "--log", "w"}), "warning\t\n");
  EXPECT_EQ(after({"camera", "record", "--codec", ""}), "lossless\t\nmjpeg\t\n");
  EXPECT_EQ(after({"run", "--out", ""}), "folders\n");
  EXPECT_EQ(after({"run", "--record", ""}), "files\n");
  EXPECT_THAT(after({"run", "--hal", "ser"}), ContainsRegex("^serial\t[^\n]+\nmore\n$"));
  EXPECT_THAT(after({"run", "--seed", ""}), "");
}

TEST(Completion, KnowsWorldsByName) {
  EXPECT_EQ(after({"run", "--world", "maze-8"}), "maze-8.maz\tworld\nfiles\n");
  EXPECT_EQ(after({"world", "check", "maze-8"}), "maze-8.maz\tworld\nfiles\n");
  EXPECT_THAT(after({"assess", "--worlds", "maze-5.maz,maze-8"}),
              HasSubstr("maze-5.maz,maze-8.maz\t"));
}

TEST(Completion, SaysNothingWhereNothingIsKnown) {
  EXPECT_EQ(after({"fly", "--no"}), "");
  EXPECT_EQ(after({"run", "--no-such=x"}), "");
  EXPECT_EQ(after({"remove", ""}), "");
}

/// A line as bash hands it over: split at = and : as well.
std::string in_bash(const std::string& folder, const std::string& words, const std::string& line) {
  const ProgramRun r = run_shell("exec bash -c '. <(eyebridge completion bash)\nCOMP_WORDS=(" +
                                     words + ") COMP_LINE=\"" + line +
                                     "\"\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1)) "
                                     "COMP_POINT=${#COMP_LINE}\n_eyebridge 2>/dev/null\n"
                                     "printf \"<%s>\" \"${COMPREPLY[@]}\"'",
                                 folder);
  EXPECT_EQ(r.exit_code, 0) << r.err;
  return r.out;
}

TEST(Completion, OfBashReplacesOnlyThePartThatItSplitsOff) {
  const ScratchFolder folder;
  folder.write("world of mine.wld", "");
  EXPECT_EQ(in_bash(folder.path(), "eyebridge run --wor", "eyebridge run --wor"), "<--world>");
  EXPECT_EQ(in_bash(folder.path(), "eyebridge run --gui = o", "eyebridge run --gui=o"),
            "<on><off>");
  EXPECT_EQ(in_bash(folder.path(), "eyebridge run --world worl", "eyebridge run --world worl"),
            "<world of mine.wld>");
  EXPECT_EQ(in_bash(folder.path(), "eyebridge run --world = worl", "eyebridge run --world=worl"),
            "<world of mine.wld>");
  EXPECT_EQ(in_bash(folder.path(), "eyebridge run --hal can : can0 \"\"",
                    "eyebridge run --hal can:can0 "),
            "<world of mine.wld>");
}

/// Its own builtins stand for the line editor, which a test does not have.
std::string in_zsh(const std::string& folder, const std::string& words, const std::string& prefix) {
  const ProgramRun r = run_shell(
      "exec zsh -f -c 'compdef() { }\ncompadd() { shift; [[ $1 = \"\" ]] && print -n \"more \"; "
      "print -n \"<${(j:><:)texts}>\" }\ncompset() { print -n \"set $* \" }\n_files() { print -n "
      "\"files $*\" }\n"
      "eval \"$(eyebridge completion zsh)\"\nwords=(eyebridge " +
          words + ") CURRENT=$#words PREFIX=\"" + prefix + "\"\n_eyebridge'",
      folder);
  EXPECT_EQ(r.err, "");
  return r.out;
}

TEST(Completion, OfZshOffersWordsAndFiles) {
  const ScratchFolder folder;
  EXPECT_EQ(in_zsh(folder.path(), "run --wor", "--wor"), "<--world>");
  EXPECT_EQ(in_zsh(folder.path(), "run --gui=o", "--gui=o"), "<--gui=on><--gui=off>");
  EXPECT_EQ(in_zsh(folder.path(), "run --out \"\"", ""), "files -/");
  EXPECT_EQ(in_zsh(folder.path(), "run --out=a", "--out=a"), "set -P *= files -/");
  EXPECT_EQ(in_zsh(folder.path(), "run --hal ser", "ser"), "more <serial>");
}

std::string in_fish(const std::string& folder, const std::string& line) {
  const ProgramRun r = run_shell(
      "exec fish --no-config -c 'eyebridge completion fish | source\n"
      "complete --do-complete \"" +
          line + "\"'",
      folder);
  EXPECT_EQ(r.exit_code, 0) << r.err;
  return r.out;
}

TEST(Completion, OfFishOffersWordsAndFiles) {
  const ScratchFolder folder;
  folder.write("world of mine.wld", "");
  EXPECT_THAT(in_fish(folder.path(), "eyebridge run --wor"), ContainsRegex("^--world\t[^\n]+\n$"));
  EXPECT_EQ(in_fish(folder.path(), "eyebridge run --gui=o"), "--gui=off\n--gui=on\n");
  EXPECT_THAT(in_fish(folder.path(), "eyebridge run --world worl"), HasSubstr("world of mine.wld"));
  EXPECT_THAT(in_fish(folder.path(), "eyebridge run --world=worl"),
              HasSubstr("--world=world of mine.wld"));
  EXPECT_THAT(in_fish(folder.path(), "eyebridge run --out worl"), Not(HasSubstr("wld")));
}

TEST(Manual, HasAPageForEveryCommand) {
  const ScratchFolder folder;
  const ProgramRun r = run_command({"manual", folder.path()}, ".");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  const std::string page = testing::file_text(folder.path() + "/eyebridge-camera-markers.1");
  EXPECT_THAT(
      page, AllOf(HasSubstr("\n.B eyebridge camera markers\n"), HasSubstr("\\fB\\-\\-spacing\\fR"),
                  HasSubstr("EyeBridge " EYEBRIDGE_VERSION)));
  EXPECT_THAT(testing::file_text(folder.path() + "/eyebridge.1"),
              HasSubstr("eyebridge\\-camera\\fR(1)"));
}

TEST(Manual, SaysWhichFolderCannotBeWrittenTo) {
  // Root may write everywhere and make every folder; nobody can make one in a device.
  const ProgramRun r = run_command({"manual", "/dev/null/none"}, ".");
  EXPECT_EQ(r.exit_code, 2);
  EXPECT_THAT(r.err, HasSubstr("/dev/null/none/eyebridge.1"));
}

}  // namespace
}  // namespace eyebridge
