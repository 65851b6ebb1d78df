// `eyebridge record`, as a user types it.
#include <filesystem>

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "command.hpp"

namespace eyebridge {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using testing::ProgramRun;
using testing::run_command;
using testing::run_shell;
using testing::ScratchFolder;

class Record : public ::testing::Test {
 protected:
  ProgramRun record(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "record");
    return run_command(arguments, folder_.path());
  }
  void expect_bad_input(const std::vector<std::string>& arguments, const std::string& message) {
    const ProgramRun r = record(arguments);
    EXPECT_EQ(r.exit_code, 2) << message;
    EXPECT_THAT(r.err, HasSubstr(message));
    EXPECT_EQ(r.out, "");
  }
  /// A program that drives and looks, built and recorded in an empty room.
  void make_recording() {
    folder_.write("prog.c",
                  "#include \"eyebot.h\"\n#include <stdio.h>\n"
                  "int main(void) {\n  VWStraight(200, 200);\n  VWWait();\n"
                  "  for (int i = 0; i < 3; ++i) printf(\"%d\\n\", PSDGet(1));\n  return 0;\n}\n");
    const ProgramRun r = run_shell(
        "eyebridge-cc prog.c -o prog\neyebridge record run.ebrec --fast ./prog\n", folder_.path());
    ASSERT_EQ(r.exit_code, 0) << r.err;
    printed_ = r.out;
  }

  ScratchFolder folder_;
  std::string printed_;
};

TEST_F(Record, IsRunWithAFileToRecordTo) {
  const std::string program =
      folder_.write("prog", "#!/bin/sh\necho \"$EYEBRIDGE_PLAN\" | cut -f1 | tail -n +2\nexit 7\n");
  chmod(program.c_str(), 0755);
  const ProgramRun r = record({"run.ebrec", "--fast", "prog", "--show"});
  EXPECT_EQ(r.exit_code, 7) << r.err;
  EXPECT_EQ(r.out, "fast=true\nrecord=run.ebrec\n\n");
  EXPECT_EQ(record({"--fast", "run.ebrec", "prog"}).out, "fast=true\nrecord=run.ebrec\n\n");
}

TEST_F(Record, ARecordingIsShownAsATable) {
  make_recording();
  const ProgramRun r = record({"--show", "run.ebrec"});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out,
              AllOf(HasSubstr("run.ebrec\n"), ContainsRegex("program +\\./prog\n"),
                    ContainsRegex("backend +sim\n"), ContainsRegex("duration +[0-9.]+ s\n"),
                    ContainsRegex("devices +drive, "), ContainsRegex("calls +[0-9]+, 0 of them"),
                    ContainsRegex("\npsd 1 read +3 +[0-9.]+ s +[0-9.]+ s +0\n"),
                    ContainsRegex("\ndrive 1 start +1 +")));
  EXPECT_THAT(r.out, ::testing::Not(HasSubstr("drive 1 start ("))) << "a listing was not asked for";
}

TEST_F(Record, ItsCallsAreListedAllOrTheFirst) {
  make_recording();
  const ProgramRun all = record({"--show", "run.ebrec", "--calls"});
  EXPECT_EQ(all.exit_code, 0) << all.err;
  EXPECT_THAT(all.out, AllOf(ContainsRegex("[0-9.]+ s  drive 1 start \\(0.2 0 0.2\\)\n"),
                             ContainsRegex("[0-9.]+ s  psd 1 read: [0-9.]+\n"),
                             ::testing::Not(HasSubstr(" more\n"))));
  const ProgramRun first = record({"--show", "run.ebrec", "--calls", "1"});
  EXPECT_THAT(first.out, ContainsRegex("start \\(0.2 0 0.2\\)\n +… +[0-9]+ more\n$"));
}

TEST_F(Record, WhatWasRecordedAnswersTheSameProgramAgain) {
  make_recording();
  const ProgramRun r = run_shell("eyebridge run --hal replay:run.ebrec ./prog\n", folder_.path());
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out, printed_);
}

TEST_F(Record, WhatIsNoRecordingIsRefusedWithOneClearMessage) {
  folder_.write("text.ebrec", "no database\n");
  folder_.write("empty.ebrec", "");
  expect_bad_input({"--show", "none.ebrec"}, "none.ebrec: ");
  expect_bad_input({"--show", "none.ebrec"}, "expected a recording (.ebrec)");
  expect_bad_input({"--show", "text.ebrec"}, "text.ebrec: ");
  expect_bad_input({"--show", "text.ebrec"}, "expected a recording (.ebrec)");
  expect_bad_input({"--show", "empty.ebrec"}, "expected a recording (.ebrec)");
  expect_bad_input({"--show", "."}, "expected a recording (.ebrec)");
}

TEST_F(Record, WrongCommandLinesAreRefused) {
  expect_bad_input({}, "found no file");
  expect_bad_input({"run.ebrec"}, "found no program");
  expect_bad_input({"run.ebrec", "no-such-program"}, "no such program");
  expect_bad_input({"run.ebrec", "--record", "b.ebrec", "prog"}, "--record: found a second file");
  expect_bad_input({"--show", "run.ebrec", "prog"}, "--show: found a program, too");
  expect_bad_input({"--calls", "3", "run.ebrec"}, "--calls");
  EXPECT_FALSE(std::filesystem::exists(folder_.path() + "/run.ebrec"));
}

}  // namespace
}  // namespace eyebridge
