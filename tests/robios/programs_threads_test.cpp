// A program with threads, which the thread sanitizer runs as well. (Those that outlive main() are
// in programs_test.cpp: they would wait for the sanitizer's own thread, too.)
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "named_program.hpp"

namespace eyebridge {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::run_named;

TEST(ProgramThreads, EachMayUseFamiliesOfItsOwn) {
  for (const auto& clock : testing::kClocks) {
    const auto r = run_named("families", clock);
    EXPECT_EQ(r.exit_code, 0) << r.err;
    // A busy computer is told of.
    EXPECT_THAT(r.err, AnyOf("", AllOf(HasSubstr("too slow"), Not(HasSubstr("error")))));
    EXPECT_THAT(r.out, HasSubstr("heard 100\n"));
    EXPECT_THAT(r.out, HasSubstr("all done\n"));
  }
}

// Without names: it would look for them in the files of the programs' copies, whose descriptors are
// other files' by then. `addr2line -Cfe build/tsan/lib/libeyebridge.so 0x2b3cfa` finds them.
constexpr const char* kSanitizer = "symbolize=0:suppressions=" EYEBRIDGE_TSAN_SUPPRESSIONS;

/// How often `part` stands in `text`.
std::size_t count_of(const std::string& part, const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

// The launcher and its 32 robots, each in a thread, in real time; one more comes.
TEST(ProgramThreads, ThirtyTwoRobotsShareAWorld) {
  const testing::ScratchFolder folder;
  folder.write("room.wld",
               "floor 3000 3000\n0 0 3000 0\n3000 0 3000 3000\n3000 3000 0 3000\n0 3000 0 0\n");
  const std::string world = folder.write(
      "crowd.sim", "world room.wld\nCan 1000 2700 0\nS4 1500 1500 0\nS4 150 150 0\nenters 0.05\n");
  const auto r = run_named("several_crowd", {{"EYEBRIDGE_FAST", "false"},
                                             {"EYEBRIDGE_FACTOR", "5"},
                                             {"EYEBRIDGE_ROBOTS", "32"},
                                             {"EYEBRIDGE_OUT", folder.path() + "/out"},
                                             {"EYEBRIDGE_WORLD", world},
                                             {"TSAN_OPTIONS", kSanitizer}});
  EXPECT_THAT(r.err, Not(HasSubstr("ThreadSanitizer")));
  EXPECT_EQ(r.exit_code, 134) << r.err;  // that of the robot that aborted
  EXPECT_EQ(count_of(" saw 20, well\n", r.out), 31U) << r.out << r.err;
  EXPECT_THAT(r.err, HasSubstr("robot 5: error: the program called abort()"));
  EXPECT_THAT(r.err, HasSubstr("eyebridge: 33 robots, "));
}

}  // namespace
}  // namespace eyebridge
