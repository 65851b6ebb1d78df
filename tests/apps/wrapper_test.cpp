#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command.hpp"

namespace eyebridge {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing::ProgramRun;
using testing::run_shell;
using testing::ScratchFolder;

const std::string kSources = EYEBRIDGE_SOURCE_DIR "/tests/apps/consumer/";

TEST(Wrapper, ATextBookProgramCompilesWithoutAWarningAndRuns) {
  const ScratchFolder folder;
  const ProgramRun r =
      run_shell("eyebridge-cc " + kSources + "prog.c -o prog\n./prog\n", folder.path());
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.err, "");
  EXPECT_EQ(r.out, "at 300 0 90\n");
}

TEST(Wrapper, EyebridgeRunGivesTheSameAsTheProgramAlone) {
  const ScratchFolder folder;
  const ProgramRun r =
      run_shell("eyebridge-cc " + kSources + "prog.c -o prog\neyebridge run prog\n", folder.path());
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out, "at 300 0 90\n");
}

TEST(Wrapper, ACppProgramCompiles) {
  const ScratchFolder folder;
  const ProgramRun r =
      run_shell("eyebridge-c++ -o prog " + kSources + "prog.cpp\n./prog\n", folder.path());
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.err, "");
  EXPECT_EQ(r.out, "sorted 1\n");
}

TEST(Wrapper, OldCWithImplicitIntAndUndeclaredFunctionsStillCompiles) {
  const ScratchFolder folder;
  const ProgramRun r =
      run_shell("eyebridge-cc " + kSources + "old.c -o old\n./old\n", folder.path());
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.err, HasSubstr("warning"));
  EXPECT_EQ(r.out, "counted 2, root 2.0\nlater\n");
}

TEST(Wrapper, ObjectsCanBeCompiledAndLinkedInTwoSteps) {
  const ScratchFolder folder;
  const ProgramRun r = run_shell(
      "eyebridge-cc -c " + kSources + "prog.c -o prog.o\neyebridge-cc prog.o -o prog\n./prog\n",
      folder.path());
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.err, "");
  EXPECT_EQ(r.out, "at 300 0 90\n");
}

TEST(Wrapper, AnErrorInTheProgramIsTheCompilers) {
  const ScratchFolder folder;
  folder.write("bad.c", "#include \"eyebot.h\"\nint main() { return 0 }\n");
  const ProgramRun r = run_shell("eyebridge-cc bad.c -o bad\n", folder.path());
  EXPECT_EQ(r.exit_code, 1);
  EXPECT_THAT(r.err, HasSubstr("bad.c:2:22: error"));
}

TEST(Wrapper, ArgumentsWithSpacesReachTheCompilerWhole) {
  const ScratchFolder folder;
  folder.write("two words.c", "#include \"eyebot.h\"\nint main() { puts(TEXT); return 0; }\n");
  const ProgramRun r =
      run_shell("eyebridge-cc '-DTEXT=\"a  b\"' 'two words.c' -o 'the program'\n'./the program'\n",
                folder.path());
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out, "a  b\n");
}

TEST(Wrapper, ProgramsMayHaveNamesOfTheCLibraryThatTheHeaderDoesNotBring) {
  const ScratchFolder folder;
  folder.write("names.c",
               "#include \"eyebot.h\"\n"
               "int open[9], stat, mkdir = 1;\n"
               "int poll(int x) { return x + 1; }\n"
               "int main() { OSWait(10); open[1] = poll(1); printf(\"%d\\n\", open[1]); }\n");
  const ProgramRun r =
      run_shell("eyebridge-cc names.c -o names\nEYEBRIDGE_OUT=out ./names\n", folder.path());
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out, "2\n");
}

TEST(Wrapper, AddsNoOptimisationAndPutsLibrariesLast) {
  const ScratchFolder folder;
  const ProgramRun r = run_shell(
      "EYEBRIDGE_TEST_PRINT=1 eyebridge-cc " + kSources + "prog.c -o prog -DMINE\n", folder.path());
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.err, Not(HasSubstr(" -O")));
  EXPECT_THAT(r.err, Not(HasSubstr(" -std")));
  EXPECT_THAT(r.err, HasSubstr(" -Wall "));
  EXPECT_THAT(r.err, HasSubstr(" -rdynamic "));
  EXPECT_THAT(r.err, HasSubstr(" -leyebridge -lm -lpthread\n"));
  EXPECT_LT(r.err.find("-DMINE"), r.err.find("-leyebridge"));
}

// Else a program's decimals, and with them the way of its robot, would be others on arm64.
TEST(Wrapper, AProductAndASumAreRoundedOneAfterTheOther) {
  const ScratchFolder folder;
  folder.write("sum.c", "double sum(double a, double b, double c) { return a * b + c; }\n");
#if defined(__x86_64__)
  const std::string machine = " -mfma";
#else
  const std::string machine;
#endif
  const ProgramRun r =
      run_shell("eyebridge-cc -O2" + machine + " -S sum.c -o sum.s\n", folder.path());
  EXPECT_EQ(r.exit_code, 0) << r.err;
  const std::string code = testing::file_text(folder.path() + "/sum.s");
  EXPECT_THAT(code, HasSubstr("mul"));
  EXPECT_THAT(code, Not(HasSubstr("madd")));
}

TEST(Wrapper, ClassicChoosesHeaderAndLibrary) {
  const ScratchFolder folder;
  folder.write("classic.c",
               "#include \"eyebot.h\"\n"
               "#include \"eyebridge.h\"\n"
               "int main() { VWHandle vw = VWInit(VW_DRIVE, 1);\n"
               "printf(\"%d %d %s\\n\", vw, imagerows, EYEBRIDGELastError()); return 0; }\n");
  const ProgramRun r = run_shell(
      "EYEBRIDGE_TEST_PRINT=1 eyebridge-cc classic.c --classic -o classic\n./classic\n"
      "eyebridge-c++ --classic -x c++ classic.c -o again\n./again\n",
      folder.path());
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out, "1 62 \n1 62 \n");
  EXPECT_THAT(r.err, HasSubstr("-leyebridge_classic -lm"));
  EXPECT_THAT(r.err, Not(HasSubstr("warning")));
}

TEST(Wrapper, TheTwoGenerationsAreNotMixed) {
  const ScratchFolder folder;
  for (const auto& [option, other] :
       {std::pair{"", "classic/eyebot.h"}, std::pair{"--classic ", "../eyebot.h"}}) {
    folder.write("both.c", std::string("#include \"eyebot.h\"\n#include \"") + other +
                               "\"\nint main() { return 0; }\n");
    const ProgramRun r =
        run_shell(std::string("eyebridge-cc ") + option + "both.c -o both\n", folder.path());
    EXPECT_EQ(r.exit_code, 1);
    EXPECT_THAT(r.err, HasSubstr("use one, by eyebridge-cc or eyebridge-cc --classic"));
  }
}

TEST(Wrapper, WithoutAProgramItAnswersAsTheCompilerDoes) {
  const ScratchFolder folder;
  const ProgramRun r = run_shell("eyebridge-cc -dumpversion\ngcc -dumpversion\n", folder.path());
  EXPECT_EQ(r.exit_code, 0) << r.err;
  const std::size_t half = r.out.size() / 2;
  EXPECT_GT(half, 1U);
  EXPECT_EQ(r.out.substr(0, half), r.out.substr(half));
}

}  // namespace
}  // namespace eyebridge
