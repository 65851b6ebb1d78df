// A run that is recorded, and the same program on its recording.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "named_program.hpp"

namespace eyebridge {
namespace {

using ::testing::HasSubstr;
using testing::ProgramRun;
using testing::run_named;
using testing::ScratchFolder;

class ProgramReplay : public ::testing::Test {
 protected:
  ProgramRun record(const std::string& program) {
    return run_named(program, {{"EYEBRIDGE_RECORD", file_}});
  }
  ProgramRun replay(const std::string& program) {
    return run_named(program, {{"EYEBRIDGE_HAL", "replay:" + file_}});
  }

  ScratchFolder folder_;
  std::string file_ = folder_.path() + "/run.ebrec";
};

TEST_F(ProgramReplay, TheSameProgramCannotTell) {
  for (const char* program : {"driving", "motors"}) {
    const ProgramRun then = record(program);
    ASSERT_EQ(then.exit_code, 0) << then.err;
    const ProgramRun now = replay(program);
    EXPECT_EQ(now.exit_code, 0) << now.err;
    EXPECT_EQ(now.out, then.out);
    EXPECT_THAT(now.err, ::testing::Not(HasSubstr("replay:")));
  }
}

TEST_F(ProgramReplay, AnotherProgramIsToldWhereItDiffers) {
  ASSERT_EQ(record("driving").exit_code, 0);
  EXPECT_THAT(replay("motors").err, HasSubstr("exchange 1: the program calls encoder 1 reset"));
}

}  // namespace
}  // namespace eyebridge
