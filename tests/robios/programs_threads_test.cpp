// A program with threads, which the thread sanitizer runs as well. (Those that outlive main() are
// in programs_test.cpp: they would wait for the sanitizer's own thread, too.)
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "named_program.hpp"

namespace eyebridge {
namespace {

using ::testing::HasSubstr;
using testing::run_named;

TEST(ProgramThreads, EachMayUseFamiliesOfItsOwn) {
  for (const auto& clock : testing::kClocks) {
    const auto r = run_named("families", clock);
    EXPECT_EQ(r.exit_code, 0) << r.err;
    EXPECT_EQ(r.err, "");
    EXPECT_THAT(r.out, HasSubstr("heard 100\n"));
    EXPECT_THAT(r.out, HasSubstr("all done\n"));
  }
}

}  // namespace
}  // namespace eyebridge
