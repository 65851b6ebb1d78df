#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "command.hpp"

namespace eyebridge {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using testing::ProgramRun;
using testing::run_command;
using testing::ScratchFolder;

/// A folder with a program that shows how it was started.
class Run : public ::testing::Test {
 protected:
  Run() {
    write_program("prog",
                  "#!/bin/sh\necho started \"$(echo \"$EYEBRIDGE_PLAN\" | tail -n +2)\"\n"
                  "for a; do echo \"<$a>\"; done\nexit 7\n");
  }
  void write_program(const std::string& name, const std::string& text) {
    const std::string path = folder_.write(name, text);
    chmod(path.c_str(), 0755);
  }
  ProgramRun run(std::vector<std::string> arguments,
                 std::map<std::string, std::string> environment = {}) {
    arguments.insert(arguments.begin(), "run");
    return run_command(arguments, folder_.path(), std::move(environment));
  }
  /// Nothing may have been started, and one line says why.
  void expect_bad_input(const ProgramRun& r, const std::string& message) {
    EXPECT_EQ(r.exit_code, 2) << r.err;
    EXPECT_THAT(r.err, HasSubstr(message));
    EXPECT_EQ(r.out, "");
  }

  ScratchFolder folder_;
};

TEST_F(Run, TheProgramGetsItsArgumentsAndItsExitCodeIsReturned) {
  const ProgramRun r = run({"prog", "--fast", "two words", "doctor"});
  EXPECT_EQ(r.exit_code, 7) << r.err;
  EXPECT_EQ(r.out, "started \n<--fast>\n<two words>\n<doctor>\n");
}

TEST_F(Run, FlagsBeforeTheProgramAreHandedOn) {
  const ProgramRun r = run({"--fast", "--seed", "42", "--keys", "KEY1@2s", "./prog"});
  EXPECT_EQ(r.exit_code, 7) << r.err;
  EXPECT_EQ(r.out,
            "started fast=true\t--fast\t0\t0\nkeys=KEY1@2s\t--keys\t0\t0\nseed=42\t--seed\t0\t0\n");
}

TEST_F(Run, ABooleanFlagCanBeTurnedOff) {
  const ProgramRun r = run({"--fast=false", "prog"});
  EXPECT_EQ(r.out, "started fast=false\t--fast\t0\t0\n") << r.err;
}

TEST_F(Run, TheLastOfTwoFlagsWins) {
  const ProgramRun r = run({"--seed=1", "--seed=2", "prog"});
  EXPECT_EQ(r.out, "started seed=2\t--seed\t0\t0\n") << r.err;
}

TEST_F(Run, FlagsOfAnOuterRunAreNotInherited) {
  const ProgramRun r =
      run({"--seed=2", "prog"}, {{"EYEBRIDGE_PLAN", "any\nfast=true\t--fast\t0\t0\n"}});
  EXPECT_EQ(r.out, "started seed=2\t--seed\t0\t0\n") << r.err;
}

TEST_F(Run, ProgramsThatAProgramStartsTakeTheFlagsAndSeeVariablesAndFilesOfTheirOwn) {
  write_program("prog",
                "#!/bin/sh\n"
                "EYEBRIDGE_REPORT=variable.txt " EYEBRIDGE_SQUARE
                " || exit\n"
                "echo 'report = \"late.txt\"' > eyebridge.toml\n" EYEBRIDGE_BIN
                "/eyebridge trust > /dev/null\n" EYEBRIDGE_SQUARE
                " || exit\n"
                "exec env EYEBRIDGE_REPORT=same_process.txt " EYEBRIDGE_SQUARE "\n");
  const ProgramRun r =
      run({"--fast", "--time-limit", "1s", "prog"}, {{"XDG_DATA_HOME", folder_.path() + "/data"}});
  ASSERT_EQ(r.exit_code, 0) << r.err;
  for (const char* report : {"variable.txt", "late.txt", "same_process.txt"}) {
    EXPECT_THAT(testing::file_text(folder_.path() + "/" + report), ContainsRegex("^time = +1\\.0"))
        << report;
  }
}

TEST_F(Run, TheProgramDoesNotReadFilesAgainThatWereChecked) {
  // Same places of eyebridge.toml, and the same process.
  folder_.write("eyebridge.toml", "report = 'checked.txt'\n");
  write_program("prog", "#!/bin/sh\necho 'what?' > eyebridge.toml\nexec ./square\n");
  std::filesystem::copy_file(EYEBRIDGE_SQUARE, folder_.path() + "/square");
  const std::map<std::string, std::string> own = {{"XDG_DATA_HOME", folder_.path() + "/data"}};
  ASSERT_EQ(run_command({"trust"}, folder_.path(), own).exit_code, 0);
  const ProgramRun r = run({"--fast", "prog"}, own);
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(testing::file_text(folder_.path() + "/checked.txt"), HasSubstr("time ="));
}

TEST_F(Run, AProgramThatIsNotInTheFolderIsFoundInPath) {
  const ProgramRun r = run({"echo", "found"});
  EXPECT_EQ(r.out, "found\n") << r.err;
}

TEST_F(Run, AProgramInTheFolderComesBeforeOneInPath) {
  write_program("echo", "#!/bin/sh\nprintf 'mine\\n'\n");
  EXPECT_EQ(run({"echo"}).out, "mine\n");
}

TEST_F(Run, NoProgramIsAnError) { expect_bad_input(run({"--fast"}), "found no program"); }

TEST_F(Run, AMissingProgramIsAnError) {
  expect_bad_input(run({"./nothing"}), "./nothing: no such program");
  expect_bad_input(run({"nothing-of-this-name"}), "no such program in this folder or in PATH");
}

TEST_F(Run, AProgramThatIsNotExecutableIsAnError) {
  folder_.write("prog.c", "int main() {}\n");
  expect_bad_input(run({"prog.c"}), "prog.c: not executable");
  expect_bad_input(run({"prog.c"}), "eyebridge-cc");
}

TEST_F(Run, AFolderIsNoProgram) { expect_bad_input(run({"."}), "found a folder"); }

TEST_F(Run, AFileThatTheKernelCannotStartIsAnError) {
  write_program("junk", std::string("\0\1\2junk", 7));
  expect_bad_input(run({"junk"}), "neither a program for this machine nor a script");
}

TEST_F(Run, AnUnknownOptionIsNotTakenForAProgram) {
  expect_bad_input(run({"--wrold", "x.maz", "prog"}), "--wrold: unknown option");
}

TEST_F(Run, AnUnknownBackendIsAnErrorThatNamesTheKnownOnes) {
  const ProgramRun r = run({"--hal", "telepathy", "prog"});
  expect_bad_input(r, "--hal: unknown backend 'telepathy'");
  EXPECT_THAT(r.err, HasSubstr("sim"));
}

TEST_F(Run, AValueOfTheWrongKindIsAnError) {
  expect_bad_input(run({"--seed", "many", "prog"}), "--seed");
  expect_bad_input(run({"--fast=maybe", "prog"}), "--fast");
}

TEST_F(Run, AValueOfTwoLinesIsAnError) {
  expect_bad_input(run({"--keys", "KEY1@1s\nseed=3", "prog"}), "--keys: found a line end");
}

TEST_F(Run, AnUnknownVariableIsAnError) {
  expect_bad_input(run({"prog"}, {{"EYEBRIDGE_WRLD", "x"}}), "EYEBRIDGE_WORLD");
}

TEST_F(Run, AnUnknownKeyInTheConfigurationFileIsNamedWithItsPlace) {
  folder_.write("eyebridge.toml", "seed = 1\nwrld = \"x\"\n");
  expect_bad_input(run({"prog"}), "eyebridge.toml:2:1");
}

TEST_F(Run, ABadSettingIsAnErrorBeforeTheProgramStarts) {
  expect_bad_input(run({"--lcd", "wide", "prog"}), "--lcd: found 'wide', expected WIDTHxHEIGHT");
  expect_bad_input(run({"--lcd", "20x20", "prog"}), "--lcd: found '20x20' for 'lcd', expected 160");
  expect_bad_input(run({"--keys", "KEY1@2s,KEY7@3s", "prog"}), "--keys:1:12: found '7@3s'");
  expect_bad_input(run({"--camera", "webcam", "prog"}), "--camera: ");
  expect_bad_input(run({"--robot", "R2D2", "prog"}), "--robot: no robot 'R2D2'");
  expect_bad_input(run({"--errors", "hash", "prog"}),
                   "--errors:1:1: unknown error model 'hash': expected 'harsh'?");
  expect_bad_input(run({"--hal", "serial:/dev/null", "--errors", "psd", "prog"}),
                   "--errors:1:4: the rule ends: expected sigma");
  expect_bad_input(run({"--robot", "R2D2", "--world", "empty-room.wld", "prog"}), "--robot: ");
}

TEST_F(Run, ABadSettingIsNamedWithWhereItCameFrom) {
  expect_bad_input(run({"prog"}, {{"EYEBRIDGE_KEYS", "KEY9@1s"}}),
                   "EYEBRIDGE_KEYS:1:4: found '9@1s'");
  expect_bad_input(run({"prog"}, {{"EYEBRIDGE_LCD", "big"}}), "EYEBRIDGE_LCD: found 'big'");
  expect_bad_input(run({"prog"}, {{"EYEBRIDGE_ROBOT", "R2"}}), "EYEBRIDGE_ROBOT: no robot 'R2'");
  expect_bad_input(run({"prog"}, {{"EYEBRIDGE_CAMERA", "film"}}), "EYEBRIDGE_CAMERA: ");
  for (const char* line : {"keys = 'KEY9@1s'", "lcd = 'a'", "robot = 'R2'", "camera = 'film'"}) {
    folder_.write("eyebridge.toml", std::string("# mine\n").append(line) + "\n");
    expect_bad_input(run({"prog"}), "eyebridge.toml:2:");
  }
}

TEST_F(Run, AFolderForResultsThatCannotBeIsAnErrorBeforeTheProgramStarts) {
  folder_.write("file", "text");
  expect_bad_input(run({"--out", "file", "prog"}), "--out: cannot write ");
  expect_bad_input(run({"--out", "file/deeper", "prog"}), "--out: cannot write file/deeper: ");
  expect_bad_input(run({"--out", "/proc/none/results", "prog"}), "--out: cannot write /proc");
  std::filesystem::create_directories(folder_.path() + "/taken/trace.csv");
  expect_bad_input(run({"--out", "taken", "prog"}), "taken/trace.csv: it is a folder");
  folder_.write("eyebridge.toml", "out = 'file'\n");
  const std::map<std::string, std::string> own = {{"XDG_DATA_HOME", folder_.path() + "/data"}};
  ASSERT_EQ(run_command({"trust"}, folder_.path(), own).exit_code, 0);
  expect_bad_input(run({"prog"}, own), "eyebridge.toml:1:7: cannot write ");
}

TEST_F(Run, NoMessageCarriesWhatATerminalObeys) {
  const std::string bad =
      "\x1b]0;owned\x07\xC2\x9B"
      "2J\nline.wld";
  folder_.write(bad, "floor 1000 1000\n\x1b[31mwall\x1b[0m 1 2\n");
  folder_.write("eyebridge.toml", "robot = \"\\u001b[31m\"\n");
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"config"},
        {"run", "prog"},
        {"run", "--robot", "S4", "--world", bad, "prog"},
        {"run", "--robot", "S4", "--world", bad + "x", "prog"},
        {"run", "--" + bad, "prog"},
        {"run", bad},
        {"world", "check", bad},
        {"world", "render", bad},
        {"record", "--show", bad},
        {"sweep", bad},
        {"firmware", "--world", bad},
        {bad}}) {
    const ProgramRun r = run_command(words, folder_.path());
    EXPECT_NE(r.err + r.out, "") << words.front();
    for (const char* const raw : {"\x1b", "\x07", "\xC2\x9B", "\nline"}) {
      EXPECT_EQ((r.err + r.out).find(raw), std::string::npos) << words.front() << ' ' << r.err;
    }
  }
}

TEST_F(Run, APipeInThePlaceOfAFileIsNotWaitedFor) {
  const std::string pipe = folder_.path() + "/pipe";
  for (const char* const name : {"pipe", "pipe.png", "pipe.wld", "pipe.ebrec", "pipe.toml"}) {
    ASSERT_EQ(mkfifo((folder_.path() + "/" + name).c_str(), 0600), 0);
  }
  folder_.write("room.wld", "floor 2000 2000\nfloor_texture pipe.png\n");
  std::filesystem::copy_file(EYEBRIDGE_SQUARE, folder_.path() + "/square");
  const std::string fast = "--fast";
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"run", fast, "--world", "pipe.wld", "square"},
        {"run", fast, "--hdt", "pipe", "square"},
        {"run", fast, "--hal", "replay:pipe.ebrec", "square"},
        {"run", fast, "--camera", "frames:pipe", "square"},
        {"run", fast, "--camera", "frames:pipe.ebrec", "square"},
        {"run", fast, "--report", "pipe", "square"},
        {"run", fast, "--record", "pipe", "square"},
        {"record", "--show", "pipe.ebrec"},
        {"world", "check", "pipe.wld"},
        {"sweep", "pipe.toml"},
        {"trust", "pipe.toml"}}) {
    EXPECT_EQ(run_command(words, folder_.path()).exit_code, 2) << words[1] << ' ' << words.back();
  }
  const ProgramRun texture = run({fast, "--strict", "--world", "room.wld", "--out", "o", "square"});
  EXPECT_NE(texture.err, "");
  ASSERT_EQ(mkfifo((folder_.path() + "/eyebridge.toml").c_str(), 0600), 0);
  expect_bad_input(run({"prog"}), "eyebridge.toml: is not a file: expected a TOML file");
}

TEST_F(Run, AMissingWorldIsAnError) {
  expect_bad_input(run({"--world", "nowhere.maz", "prog"}), "nowhere.maz");
  expect_bad_input(run({"--sim", "nowhere.sim", "prog"}), "nowhere.sim");
}

TEST_F(Run, ABadWorldIsAnErrorBeforeTheProgramStartsWhenThatIsAskedFor) {
  folder_.write("bad.wld", "floor 1000 1000\npop\n");
  expect_bad_input(run({"--strict", "--world", "bad.wld", "prog"}), "bad.wld:2:1");
}

}  // namespace
}  // namespace eyebridge
