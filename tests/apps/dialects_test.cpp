// Programs as people write them and build them, through the wrappers.

#include <filesystem>

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

const std::string kDialects = EYEBRIDGE_SOURCE_DIR "/tests/apps/consumer/";

class Dialect : public ::testing::Test {
 protected:
  /// Compiles with `line`, which makes x.x, and runs that.
  ProgramRun build(const std::string& line) {
    return run_shell(line + "\n./x.x\n", folder_.path());
  }
  ScratchFolder folder_;
};

TEST_F(Dialect, AMakefileOfEyeSimWorksAsItIs) {
  folder_.write("maze.c", "#include \"eyebot.h\"\nint main() { puts(\"c\"); return 0; }\n");
  folder_.write("swarm.cpp",
                "#include \"eyebot++.h\"\n#include <iostream>\nint main() { std::cout << 'p'; }\n");
  folder_.write(
      "Makefile",
      "all: maze.x swarm.x two.x\n"
      "%.x: %.c\n\tgccsim -o $@ $< -leyesim -lX11 -lm\n"
      "%.x: %.cpp\n\tg++sim -o $@ $< -leyebot -lpthread\n"
      "two.x: maze.c\n\tgccarm maze.c -o two.x -L/opt/eyesim/lib -I../include -lX11 -leyebot\n"
      "\tg++arm swarm.cpp -o three.x\n");
  const ProgramRun r =
      run_shell("make -s\n./maze.x; ./swarm.x; ./two.x; ./three.x\n", folder_.path());
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out, "c\npc\np");
  EXPECT_EQ(r.err, "");
}

TEST_F(Dialect, AWrapperInTheFolderAboveWorks) {
  std::filesystem::create_directory(folder_.path() + "/lab");
  folder_.write("lab/x.c", "#include \"eyebot.h\"\nint main() { return 0; }\n");
  const ProgramRun r =
      run_shell("ln -s \"$(command -v gccsim)\" gccsim\ncd lab\n../gccsim -o x.x x.c\n./x.x\n",
                folder_.path());
  EXPECT_EQ(r.exit_code, 0) << r.err;
}

TEST_F(Dialect, HeadersByOtherNamesAreThereAndAProgramsOwnComeFirst) {
  std::filesystem::create_directory(folder_.path() + "/own");
  folder_.write("own/types.h", "#define WHOSE \"its own\\n\"\n");
  folder_.write("x.c",
                "#include \"eyebot.h\"\n#include \"types.h\"\n#ifndef WHOSE\n#define WHOSE "
                "\"ours\\n\"\n#endif\n"
                "int main() { printf(WHOSE); return 0; }\n");
  folder_.write(
      "demo.c",
      "#include \"include/eyebot.h\"\nint main() { LCDPrintf(\"x\"); return KEY1 - KEY1; }\n");
  EXPECT_EQ(build("gccsim x.c -o x.x").out, "ours\n");
  EXPECT_EQ(build("gccsim x.c -Iown -o x.x").out, "its own\n");
  EXPECT_EQ(build("gccsim --classic x.c -o x.x").out, "ours\n");
  for (const char* line : {"gccsim demo.c -o x.x", "gccsim --classic demo.c -o x.x"}) {
    const ProgramRun r = build(line);
    EXPECT_EQ(r.exit_code, 0) << line << r.err;
    EXPECT_EQ(r.err, "");
  }
}

TEST_F(Dialect, AnInlineFunctionOfClassicCIsThereForOtherFiles) {
  folder_.write(
      "a.c", "#include \"near.h\"\n__inline__ int near_hue(int a, int b) { return a - b < 10; }\n");
  folder_.write("near.h", "__inline__ int near_hue(int, int);\n");
  folder_.write("main.c",
                "#include \"eyebot.h\"\n#include \"near.h\"\n"
                "int main() { printf(\"%d\", near_hue(3, 5)); return 0; }\n");
  const ProgramRun r = build("gccsim --classic main.c a.c -o x.x");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out, "1");
}

TEST_F(Dialect, OldCGivesWarningsOnly) {
  folder_.write(
      "x.c",
      "#include \"eyebot.h\"\n"
      "static twice(a, b) int a; char *b; { return 2 * a; }\n"
      "void main() { int *p = 5; char c; c = p; printf(\"%d %.1f\\n\", twice(4, 1), sqrt(4.0)); "
      "later(1); exit(0); }\n"
      "later() { printf(\"later\\n\"); }\n");
  const ProgramRun r = build("gccsim -o x.x x.c");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out, "8 2.0\nlater\n");
  EXPECT_THAT(r.err, HasSubstr("warning"));
  EXPECT_THAT(r.err, Not(HasSubstr("error")));
}

TEST_F(Dialect, LooseCppGivesWarningsOnly) {
  folder_.write(
      "x.cpp",
      "#include \"eyebot++.h\"\n"
      "const twice(int a) { return 2 * a; }\n"
      "int main() { int n = 5; int *p = n; printf(\"%d\\n\", twice(p == 0 ? 0 : 4)); }\n");
  const ProgramRun r = build("g++sim -o x.x x.cpp");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out, "8\n");
  EXPECT_THAT(r.err, Not(HasSubstr("error")));
}

TEST_F(Dialect, Cpp20NeedsNoFlagAndOlderCppMayAskForItsOwn) {
  folder_.write(
      "x.cpp",
      "#include \"eyebot++.h\"\n#include <ranges>\n#include <vector>\nusing namespace std;\n"
      "struct P { int x, y; auto operator<=>(const P&) const = default; };\n"
      "int main() { vector<int> v{3, 1, 2}; ranges::sort(v);\n"
      "  P p{.x = 1, .y = 2}; printf(\"%d %d\\n\", v[0], p > P{0, 5}); }\n");
  EXPECT_EQ(build("g++sim -o x.x x.cpp").out, "1 1\n");
  folder_.write("x.cpp",
                "#include \"eyebot++.h\"\nint main() { printf(\"%ld\\n\", __cplusplus); }\n");
  EXPECT_EQ(build("g++sim -std=c++11 -o x.x x.cpp").out, "201103\n");
}

TEST_F(Dialect, TwoSourcesMayShareAVariableThatBothDefine) {
  folder_.write("map.h", "#include \"eyebot.h\"\nint grid[100];\nint visited;\nvoid look(void);\n");
  folder_.write(
      "x.c", "#include \"map.h\"\nint main() { look(); printf(\"%d\\n\", visited + grid[3]); }\n");
  folder_.write("look.c", "#include \"map.h\"\nvoid look(void) { visited = 40; grid[3] = 2; }\n");
  EXPECT_EQ(build("gccsim -o x.x x.c look.c").out, "42\n");
}

TEST_F(Dialect, CodeMayBeIncludedAndFilesBeOfAnyKind) {
  // CR LF; then Latin-1 and Shift-JIS in comments and strings.
  folder_.write("image.c",
                "#include \"eyebot.h\"\r\nint half(int a)\r\n{\r\n  return a / \\\r\n 2;\r\n}\r\n");
  folder_.write(
      "x.c",
      "#include \"image.c\" /* f\xFCr */\r\n// \x83\x8D\x83{\x83\x62\x83g\r\n"
      "int main(void)\r\n{\r\n  printf(\"%d gr\xFC\xDF\\n\", half(84));\r\n  return 0;\r\n}");
  const ProgramRun r = build("gccsim -o x.x x.c");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out, "42 gr\xFC\xDF\n");
}

TEST_F(Dialect, LargeArraysAndEndsOfEveryKind) {
  folder_.write("x.c",
                "#include \"eyebot.h\"\n"
                "static int fill(void) { BYTE big[600 * 1024]; memset(big, 1, sizeof big); "
                "LCDImageSize(QVGA);\n"
                "  LCDImage(big); return big[5000]; }\n"
                "static void* worker(void* unused) { OSWait(100); printf(\"worker\\n\"); "
                "fflush(stdout); return 0; }\n"
                "int main(int argc, char **argv)\n{\n  pthread_t t;\n  printf(\"%d\\n\", "
                "fill());\n  fflush(stdout);\n"
                "  if (argc > 1 && argv[1][0] == 'e') exit(4);\n"
                "  if (argc > 1 && argv[1][0] == 'p') { pthread_create(&t, NULL, worker, 0); "
                "pthread_exit(0); }\n}\n");
  const ProgramRun r = run_shell(
      "gccsim -o x.x x.c 2>/dev/null\n./x.x; echo $?\n./x.x p; echo $?\n./x.x e || echo $?\n",
      folder_.path());
  EXPECT_EQ(r.out, "1\n0\n1\nworker\n0\n1\n4\n") << r.err;
}

TEST_F(Dialect, AnEmptyLoopSeesWhatATimerCounts) {
  folder_.write("x.c",
                "#include \"eyebot.h\"\nint count = 0;\nvoid tick() { count++; }\n"
                "int main() { OSAttachTimer(1, tick); while (count < 5) {} printf(\"enough\\n\"); "
                "return 0; }\n");
  EXPECT_EQ(run_shell("gccsim -o x.x x.c\nEYEBRIDGE_FAST=false ./x.x\n", folder_.path()).out,
            "enough\n");
}

TEST_F(Dialect, ProgramsKeepTheirNamesInCAndCpp) {
  for (const std::string compiler : {"gccsim -w", "g++sim -w -x c++"}) {
    const ProgramRun r = run_shell(compiler + " -o x.x " + kDialects +
                                       "names.c\n./x.x\neyebridge run --out out ./x.x\n"
                                       "test -s out/lcd.png\n",
                                   folder_.path());
    EXPECT_EQ(r.exit_code, 0) << compiler << r.err;
    EXPECT_EQ(r.out, "12 called, 0 wrongly, at 40\n12 called, 0 wrongly, at 40\n") << compiler;
  }
}

TEST_F(Dialect, BothHeadersInEitherOrderGiveWhatTheOriginalsGave) {
  const std::string rest =
      "int main() { bool b = True; srand(1); signal(SIGINT, SIG_DFL); usleep(10); sleep(0); "
      "XInitThreads();\n"
      "  char text[20]; sprintf(text, \"%d\", abs(-3)); char *word = strtok(text, \" \"); FILE "
      "*none = fopen(\"/none\", \"r\");\n"
      "  int n = 0; sscanf(word, \"%d\", &n); struct timeval now; gettimeofday(&now, NULL); errno "
      "= 0; pthread_t t = pthread_self();\n"
      "  sem_t s; sem_init(&s, 0, 1); void *m = malloc(3); free(m); size_t z = strlen(word); "
      "int32_t i = atol(word) + atoi(word);\n"
      "  fprintf(stderr, \"%s\", strcmp(word, \"3\") || None_of_ours() ? \"no\" : \"\"); (void)t; "
      "(void)z;\n"
      "  double a = atan2(1, 1) * 4 - M_PI; return b && !False && n == 3 && i == 6 && !none && "
      "fabs(a) < 1e-9 && rand() <= RAND_MAX\n"
      "    ? EXIT_SUCCESS : EXIT_FAILURE; }\n";
  for (const std::string headers : {"#include \"eyebot.h\"\n#include \"eyebot++.h\"\n",
                                    "#include \"eyebot++.h\"\n#include \"eyebot.h\"\n"}) {
    // Names of headers that the originals did not bring: they are the program's.
    const std::string ours =
        "#if defined LINE_MAX || defined PATH_MAX || defined O_RDONLY || defined POLLIN\n#error "
        "too much\n#endif\n"
        "static int None_of_ours(void) { return 0; }\n";
    folder_.write("x.c", headers + ours + rest);
    const ProgramRun c = build("gccsim -Werror -o x.x x.c");
    EXPECT_EQ(c.exit_code, 0) << c.err;
    folder_.write("x.cpp", headers + "static int None_of_ours() { return 0; }\n" + rest);
    const ProgramRun cpp = build("g++sim -Werror -o x.x x.cpp");
    EXPECT_EQ(cpp.exit_code, 0) << cpp.err;
  }
}

TEST_F(Dialect, X11MayComeBeforeOrAfterWhereItIsInstalled) {
  folder_.write("Xlib.h",
                "#define Bool int\n#define Status int\n#define True 1\n#define False 0\nextern "
                "Status XInitThreads(void);\n");
  for (const std::string headers : {"#include \"Xlib.h\"\n#include \"eyebot.h\"\n",
                                    "#include \"eyebot.h\"\n#include \"Xlib.h\"\n"}) {
    for (const std::string compiler :
         {"gccsim -Werror -o x.x x.c", "g++sim -Werror -o x.x -x c++ x.c"}) {
      // Xlib.h declares its functions as C's.
      folder_.write("x.c", "#ifdef __cplusplus\nextern \"C\" {\n#endif\n" + headers +
                               "#ifdef __cplusplus\n}\n#endif\nint main(void) { return "
                               "XInitThreads() ? False : True; }\n");
      const ProgramRun r = build(compiler);
      EXPECT_EQ(r.exit_code, 0) << r.err;
    }
  }
}

}  // namespace
}  // namespace eyebridge
