#include "code/run_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "code/examples.hpp"
#include "run_program.hpp"

namespace eyebridge::gui {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

class RunPlan : public ::testing::Test {
 protected:
  RunPlan() {
    settings_.eyebridge = "/bin/eyebridge";
    settings_.c_compiler = "/bin/eyebridge-cc";
    settings_.cpp_compiler = "/bin/eyebridge-c++";
    settings_.builds = "/builds";
  }
  QString write(const char* name, const char* text) {
    return QString::fromStdString(folder_.write(name, text));
  }

  eyebridge::testing::ScratchFolder folder_;
  CodeSettings settings_;
};

TEST_F(RunPlan, PythonIsRunAsItIs) {
  const auto plan =
      plan_run({"/home/me/a b.py", "", Language::Python, false, ""}, {"", false, true}, settings_);
  ASSERT_THAT(plan, SizeIs(1));
  EXPECT_EQ(plan[0].program, "/bin/eyebridge");
  EXPECT_THAT(plan[0].arguments, ElementsAre("run", "--gui", "/home/me/a b.py"));
  EXPECT_EQ(plan[0].folder, "/home/me");
}

TEST_F(RunPlan, ChoicesAreOptions) {
  const auto plan = plan_run({"/home/me/a.py", "", Language::Python, false, ""},
                             {"/w/maze.maz", true, false}, settings_);
  EXPECT_THAT(plan[0].arguments,
              ElementsAre("run", "--world", "/w/maze.maz", "--fast", "--no-gui", "/home/me/a.py"));
}

TEST_F(RunPlan, CIsBuiltFirst) {
  const QString file = write("a.c", "int main() {}\n");
  const auto plan = plan_run({file, "", Language::C, true, ""}, {}, settings_);
  ASSERT_THAT(plan, SizeIs(2));
  EXPECT_EQ(plan[0].kind, Step::Kind::Build);
  EXPECT_EQ(plan[0].program, "/bin/eyebridge-cc");
  EXPECT_EQ(plan[0].arguments.front(), "--classic");
  EXPECT_THAT(plan[0].arguments, Contains("a.c"));
  EXPECT_EQ(plan[1].arguments.back(), plan[0].arguments.back()) << "what was built is run";
  EXPECT_TRUE(plan[1].arguments.back().startsWith("/builds/"));
  const auto cpp = plan_run({file, "", Language::Cpp, false, ""}, {}, settings_);
  EXPECT_EQ(cpp[0].program, "/bin/eyebridge-c++");
  EXPECT_THAT(cpp[0].arguments, Not(Contains("--classic")));
}

TEST_F(RunPlan, HeadersAndTextsAreNoPrograms) {
  EXPECT_THAT(plan_run({"/a/b.h", "", Language::C, false, ""}, {}, settings_), IsEmpty());
  EXPECT_THAT(plan_run({"/a/b.txt", "", Language::Text, false, ""}, {}, settings_), IsEmpty());
}

TEST_F(RunPlan, ProgramsOfTheSameNameDoNotShareABuild) {
  EXPECT_NE(build_folder(settings_, "/a/x.c"), build_folder(settings_, "/b/x.c"));
  EXPECT_EQ(build_folder(settings_, "/a/x.c"), build_folder(settings_, "/a/x.c"));
}

TEST_F(RunPlan, SourcesBesideAreThoseOfIncludedHeaders) {
  const QString main =
      write("main.cpp",
            "#include \"map.hpp\"\n# include \"lost.hpp\"\n#include <eyebot.h>\nint main() {}\n");
  write("map.hpp", "#include \"grid.h\"\n");
  const QString map = write("map.cpp", "#include \"map.hpp\"\n#include \"deep.h\"\n");
  write("grid.h", "#include \"map.hpp\"\n");
  write("deep.h", "");
  const QString deep = write("deep.c", "");
  write("other.cpp", "int main() {}\n");
  const QString home = QString::fromStdString(folder_.path());
  EXPECT_THAT(other_sources(main, home), ElementsAre(map, deep));
}

TEST_F(RunPlan, ExamplesAreRobotProgramsOnly) {
  std::vector<std::string> names;
  for (const Example& example : find_examples(EYEBRIDGE_SOURCE_DIR "/examples")) {
    names.push_back(example.name.toStdString());
  }
  EXPECT_THAT(names, Contains("square.c"));
  EXPECT_THAT(names, Contains("wall_follow.py"));
  EXPECT_THAT(names, Contains("maze_explorer/maze_explorer.cpp"));
  EXPECT_THAT(names, Not(Contains("maze_explorer/maze_map.cpp")));
  EXPECT_THAT(names, Not(Contains("training/evolve_wall_follower.cpp")));
  EXPECT_THAT(find_examples(""), IsEmpty());
  EXPECT_THAT(find_examples("/nowhere"), IsEmpty());
}

}  // namespace
}  // namespace eyebridge::gui
