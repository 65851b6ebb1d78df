#include <cstdlib>

#include <gmock/gmock.h>

#include "run_program.hpp"

// `run` and `eyebridge lab`, from outside.
namespace eyebridge::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

ProgramRun lab(std::vector<std::string> arguments,
               std::map<std::string, std::string> environment = {},
               const std::string& folder = "") {
  arguments.insert(arguments.begin(), EYEBRIDGE_LAB "/run");
  return run_program({arguments, std::move(environment), folder});
}

TEST(LabRun, PassesOnExitCodeAndBothOutputs) {
  const ProgramRun run = lab({"--", "sh", "-c", "echo out; echo err >&2; exit 7"});
  EXPECT_EQ(run.exit_code, 7);
  EXPECT_EQ(run.out, "out\n");
  EXPECT_EQ(run.err, "err\n");
}

TEST(LabRun, PassesOnEveryByteOfALongOutput) {
  const ProgramRun run = lab({"--", "/usr/bin/python3", "-c",
                              "import sys; sys.stdout.buffer.write(bytes(range(256)) * 4096)"});
  ASSERT_EQ(run.out.size(), 256u * 4096u);
  std::string expected;
  for (int i = 0; i < 256; ++i) expected += static_cast<char>(i);
  for (std::size_t at = 0; at < run.out.size(); at += 256) {
    ASSERT_EQ(run.out.compare(at, 256, expected), 0) << "at " << at;
  }
}

TEST(LabRun, PassesOnArgumentsEnvironmentAndFolderAsTheyAre) {
  const ScratchFolder folder;
  const ProgramRun run = lab({"--", "sh", "-c", "printf '%s|' \"$@\" \"$LAB_TEST\" \"$PWD\"", "sh",
                              "two words", "", "$HOME \"'\n"},
                             {{"LAB_TEST", " a=b\n"}}, folder.path());
  EXPECT_EQ(run.out, "two words||$HOME \"'\n| a=b\n|" + folder.path() + "|");
}

TEST(LabRun, ASignalThatEndsTheCommandIsInTheExitCode) {
  EXPECT_EQ(lab({"--", "sh", "-c", "kill -SEGV $$"}).exit_code, 128 + 11);
}

TEST(LabRun, ACommandThatIsNotThereIs127) {
  const ProgramRun run = lab({"--", "no-such-command"});
  EXPECT_EQ(run.exit_code, 127);
  EXPECT_EQ(run.err, "lab: cannot run no-such-command: No such file or directory\n");
}

TEST(LabRun, ATimeOutIs124) {
  const ProgramRun run = lab({"--timeout", "1", "--", "sleep", "1000"});
  EXPECT_EQ(run.exit_code, 124);
  EXPECT_EQ(run.err, "lab: ended after 1 s\n");
}

TEST(LabRun, AGuestThatDoesNotComeUpIs125AndShowsItsConsole) {
  const ProgramRun run = lab({"--module", "no_such_module", "--", "true"});
  EXPECT_EQ(run.exit_code, 125);
  EXPECT_THAT(run.err, HasSubstr("no_such_module not found"));
}

TEST(LabRun, WithoutItsKernelItSaysWhatBuildsIt) {
  const ScratchFolder empty;
  const ProgramRun run = lab({"--", "true"}, {{"XDG_CACHE_HOME", empty.path()}});
  EXPECT_EQ(run.exit_code, 125);
  EXPECT_THAT(run.err, StartsWith("lab: the guest kernel is not built\n"));
  EXPECT_THAT(run.err, HasSubstr(EYEBRIDGE_LAB "/build"));
}

TEST(LabRun, OnlyWhatIsBelowASharedFolderReachesTheHost) {
  const ScratchFolder shared;
  const ScratchFolder other;
  const ProgramRun run = lab({"--rw", shared.path(), "--", "sh", "-ec",
                              "echo kept >$1/file; echo lost >$2/file; cat $2/file", "sh",
                              shared.path(), other.path()});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out, "lost\n");
  EXPECT_EQ(file_text(shared.path() + "/file"), "kept\n");
  EXPECT_EQ(file_text(other.path() + "/file"), "");
}

TEST(LabRun, BadOptionsAreRefusedBeforeAnythingStarts) {
  EXPECT_THAT(lab({"--rw", "/no/such", "--", "true"}).err,
              HasSubstr("--rw /no/such: no such folder"));
  EXPECT_THAT(lab({"--wrong", "--", "true"}).err, HasSubstr("unknown option --wrong"));
  EXPECT_THAT(lab({"--timeout", "soon", "--", "true"}).err, HasSubstr("take whole numbers"));
  EXPECT_EQ(lab({}).exit_code, 125);
}

TEST(LabTimeTravel, ADayOfSleepTakesNoneAndIsExact) {
  const char* const program =
      "import time; t = time.monotonic(); time.sleep(86400); print(round(time.monotonic() - t, 2))";
  const ProgramRun run =
      lab({"--time-travel", "--timeout", "50", "--", "/usr/bin/python3", "-c", program});
  EXPECT_EQ(run.out, "86400.0\n") << run.err;
}

TEST(EyebridgeLab, IsTheSameForUsers) {
  const ProgramRun run = run_program({{EYEBRIDGE_BIN "/eyebridge", "lab", "--", "sh", "-c",
                                       "cat /sys/class/net/vcan1/mtu; exit 3"},
                                      {},
                                      ""});
  EXPECT_EQ(run.exit_code, 3) << run.err;
  EXPECT_EQ(run.out, "72\n");
}

TEST(EyebridgeLab, PassesItsOptionsOn) {
  const ProgramRun run =
      run_program({{EYEBRIDGE_BIN "/eyebridge", "lab", "--rw", "/tmp", "--time-travel", "--rw",
                    "/var/tmp", "--", "sh", "-c", "sleep 500; echo \"$@\"", "sh", "--rw", "-h"},
                   {},
                   ""});
  EXPECT_EQ(run.out, "--rw -h\n") << run.err;
}

TEST(EyebridgeLab, DoctorFindsNoFaultWithCanInThere) {
  const ProgramRun run = run_program(
      {{EYEBRIDGE_BIN "/eyebridge", "lab", "--", EYEBRIDGE_BIN "/eyebridge", "doctor"}, {}, ""});
  EXPECT_THAT(run.out, HasSubstr("vcan0 vcan1")) << run.err;
  EXPECT_THAT(run.out, ::testing::ContainsRegex("CAN ISO-TP +ok")) << run.out;
}

}  // namespace
}  // namespace eyebridge::testing
