// What is wrong with --camera is said before the program's first call returns, not at CAMInit.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run_program.hpp"

namespace eyebridge {
namespace {

using ::testing::HasSubstr;
using testing::ProgramRun;

ProgramRun run(const std::string& camera, const std::string& world) {
  return testing::run_program({{std::string(EYEBRIDGE_TEST_PROGRAMS) + "/clocks"},
                               {{"EYEBRIDGE_FAST", "true"},
                                {"EYEBRIDGE_CAMERA", camera},
                                {"EYEBRIDGE_WORLD", std::string(EYEBRIDGE_SOURCE_DIR) + world}},
                               ""});
}

class BadCamera : public ::testing::TestWithParam<const char*> {};

TEST_P(BadCamera, EndsTheRunBeforeItBegins) {
  const ProgramRun r = run(GetParam(), "/worlds/empty-room.wld");
  EXPECT_EQ(r.exit_code, 2);
  EXPECT_EQ(r.out, "");
  EXPECT_THAT(r.err, HasSubstr("EYEBRIDGE_CAMERA: "));
  EXPECT_THAT(r.err, HasSubstr(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Settings, BadCamera,
                         ::testing::Values("film", "render:vulkan", "pattern:bars"));

TEST(CameraSetting, ARenderAskedForNeedsARobotWithACamera) {
  const ProgramRun r = run("render", "/worlds/rookie.p");
  EXPECT_EQ(r.exit_code, 2);
  EXPECT_THAT(r.err, HasSubstr("this robot has none"));
}

TEST(CameraSetting, ARobotWithoutCameraRunsProgramsThatNeedNone) {
  EXPECT_EQ(run("none", "/worlds/rookie.p").exit_code, 0);
  EXPECT_EQ(run("pattern", "/worlds/rookie.p").exit_code, 0);
}

}  // namespace
}  // namespace eyebridge
