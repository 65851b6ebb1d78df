// Worlds whose robots name their programs: `eyebridge run --world FILE.sim`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "command.hpp"

namespace eyebridge {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::run_command;
using testing::run_shell;
using testing::ScratchFolder;

constexpr const char* kFleetRoom =
    "floor 3000 3000\n0 0 3000 0\n3000 0 3000 3000\n3000 3000 0 3000\n0 3000 0 0\n";

/// A room, and a program that tells its robot's number and words.
class Scenario : public ::testing::Test {
 protected:
  Scenario() {
    folder_.write("room.wld", kFleetRoom);
    folder_.write("prog.c",
                  "#include <eyebot.h>\n#include <stdio.h>\n"
                  "int main(int argc, char** argv) {\n"
                  "  OSWait(100 * OSMachineID());\n"
                  "  printf(\"%d %s\\n\", OSMachineID(), argc > 1 ? argv[1] : \"none\");\n"
                  "  return 0;\n}\n");
    compile("prog.c -o prog");
  }
  void compile(const std::string& words) {
    const auto built = run_shell("eyebridge-cc " + words, folder_.path());
    EXPECT_EQ(built.exit_code, 0) << built.err;
  }
  testing::ProgramRun run(const std::string& robots) {
    const auto sim = folder_.write("all.sim", "world room.wld\n" + robots);
    return run_command({"run", "--fast", "--world", sim}, folder_.path());
  }

  ScratchFolder folder_;
};

TEST_F(Scenario, EachRobotRunsWhatItsLineNames) {
  const auto r = run("S4 500 500 0 prog one\nS4 1500 500 90 prog two\nS4 2500 2500 0\n");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out, "1 one\n2 two\n");  // the third has none and stands
  EXPECT_THAT(r.err, HasSubstr("eyebridge: 2 robots"));
}

TEST_F(Scenario, ErrorsMayBeThoseOfARobotThatTheCountMakes) {
  folder_.write("psd.c",
                "#include <eyebot.h>\n#include <stdio.h>\n"
                "int main(void) {\n  int i, same = 1, first = PSDGet(1);\n"
                "  for (i = 0; i < 50; i++) same &= PSDGet(1) == first;\n"
                "  printf(\"%d %s\\n\", OSMachineID(), same ? \"steady\" : \"noisy\");\n"
                "  return 0;\n}\n");
  compile("psd.c -o psd");
  const auto with = [&](const std::string& errors) {
    return run_command({"run", "--fast", "--world", folder_.path() + "/room.wld", "--robots", "2",
                        "--errors", errors, "psd"},
                       folder_.path());
  };
  const auto second = with("robot:2 psd sigma=9");
  EXPECT_EQ(second.exit_code, 0) << second.err;
  EXPECT_THAT(second.out, AllOf(HasSubstr("1 steady\n"), HasSubstr("2 noisy\n")));
  const auto third = with("robot:3 psd sigma=9");
  EXPECT_EQ(third.exit_code, 2);
  EXPECT_EQ(third.err, "eyebridge: --errors:1:1: found robot 3: expected 1 to 2\n");
}

// EyeSim 1 to 4's own file: one type of robot, which stands at each start of its world.
TEST_F(Scenario, AParameterFilePlacesSeveralAtTheStartsOfItsWorld) {
  folder_.write("where.c",
                "#include <eyebot.h>\n#include <stdio.h>\n"
                "int main(void) {\n"
                "  int x, y, z, phi;\n"
                "  OSWait(100 * OSMachineID());\n"
                "  SIMGetRobot(0, &x, &y, &z, &phi);\n"
                "  printf(\"%d: %d %d %d\\n\", OSMachineID(), x, y, phi);\n"
                "  return 0;\n}\n");
  compile("where.c -o where");
  folder_.write("starts.wld", std::string(kFleetRoom) +
                                  "position 500 500 90\nposition 1500 500 180\n"
                                  "position 2500 2500 0\n");
  folder_.write("starts.maz", " _ _ _\n|S|  S|\n|_ _|S|\n");
  const auto in = [&](const std::string& ground, const std::string& robots) {
    folder_.write("fleet.p", "name Rookie\ndiameter 100\n" + ground + "\nerror perfect\n");
    return run_command({"run", "--fast", "--world", "fleet.p", "--robots", robots, "where"},
                       folder_.path());
  };
  const std::string three = "1: 500 500 90\n2: 1500 500 180\n3: 2500 2500 0\n";
  for (const char* robots : {"3", "all"}) {
    const auto r = in("world starts.wld", robots);
    EXPECT_EQ(r.out, three) << r.err;
    EXPECT_EQ(r.exit_code, 0);
    EXPECT_THAT(r.err, HasSubstr("eyebridge: 3 robots"));
  }
  EXPECT_THAT(in("world starts.wld", "4").out, HasSubstr(three + "4: "));
  EXPECT_EQ(in("world starts.wld", "1").out, "1: 500 500 90\n");
  EXPECT_THAT(in("maze starts.maz", "all").err, HasSubstr("eyebridge: 3 robots"));
  const auto many = in("world starts.wld", "9999");
  EXPECT_EQ(many.exit_code, 2);
  EXPECT_THAT(many.err, HasSubstr("--robots: found 9999 robots, but this world has room for"));
}

TEST_F(Scenario, ARobotMayEnterLaterAndOnlyThatMayRunAProgram) {
  const auto r = run("S4 500 500 0\nS4 500 1000 0 prog late\nenters 2\n");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_EQ(r.out, "2 late\n");
  EXPECT_THAT(r.err, HasSubstr("eyebridge: 1 robots, 2.20 s"));
}

TEST_F(Scenario, AProgramThatIsNotThereIsThatRobotsTrouble) {
  const auto r = run("S4 500 500 0 nowhere\nS4 1500 500 90 prog two\nS4 2500 2500 0 prog.c\n");
  EXPECT_EQ(r.exit_code, 126);
  EXPECT_EQ(r.out, "2 two\n");
  EXPECT_THAT(r.err, AllOf(HasSubstr("robot 1: error: nowhere: no such program"),
                           HasSubstr("prog.c: not executable")));
}

TEST_F(Scenario, WithoutAnyProgramItIsAnError) {
  const auto r = run("S4 500 500 0\n");
  EXPECT_EQ(r.exit_code, 2);
  EXPECT_THAT(r.err, HasSubstr("all.sim: found no robot with a program"));
}

TEST_F(Scenario, TheSecondRobotOnOnePlaceIsPutBesideIt) {
  const auto r = run("S4 500 500 0 prog\nS4 500 500 0 prog\n");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.err, AllOf(HasSubstr("all.sim:3:"), HasSubstr(": it is put to (690, 500) mm")));
}

TEST_F(Scenario, ProgramsThatCannotBeLoadedTwiceHaveProcessesOfTheirOwn) {
  folder_.write("own.c",
                "#include <eyebot.h>\n#include <stdio.h>\nstatic __thread int mine;\n"
                "int main(void) {\n"
                "  for (int i = 0; i < 3; ++i) mine += OSWait(10) + OSMachineID();\n"
                "  printf(\"%d\\n\", mine);\n  return 0;\n}\n");
  compile("own.c -o own");
  const auto own = run("S4 500 500 0 own\nS4 1500 500 90 prog\nS4 500 1500 0 own\n");
  EXPECT_EQ(own.exit_code, 0) << own.err;
  EXPECT_THAT(own.out, AllOf(HasSubstr("3\n"), HasSubstr("9\n"), HasSubstr("2 none\n")));
  compile("-no-pie prog.c -o fixed");
  const auto fixed = run("S4 500 500 0 fixed one\nS4 1500 500 90 prog two\n");
  EXPECT_EQ(fixed.exit_code, 0) << fixed.err;
  EXPECT_THAT(fixed.out, AllOf(HasSubstr("1 one\n"), HasSubstr("2 two\n")));
}

TEST_F(Scenario, AFileThatIsNoProgramSaysSo) {
  folder_.write("text", "no program");
  ASSERT_EQ(chmod((folder_.path() + "/text").c_str(), 0755), 0);
  EXPECT_THAT(run("S4 500 500 0 text\nS4 1500 500 90 prog\n").err,
              HasSubstr("found a file that is no program"));
}

}  // namespace
}  // namespace eyebridge
