// Programs with threads and timers, which the thread sanitizer runs as well.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "named_program.hpp"

namespace eyebridge {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
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

TEST(ProgramThreads, MayOutliveMain) {
  for (const auto& clock : testing::kClocks) {
    const auto r = run_named("threads", clock);
    EXPECT_EQ(r.exit_code, 0) << r.err;
    EXPECT_THAT(r.out, HasSubstr("drove\n"));
    EXPECT_THAT(r.err, Not(HasSubstr("ThreadSanitizer")));
  }
}

TEST(ProgramThreads, AnyNumberOfTimersRunOnTimeAndOsWaitDoesNotNotice) {
  const auto r = run_named("many_timers");
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("quick 1000\nwaited 1000\ncalls 5000\n"));
  const auto real = run_named("many_timers", {{"EYEBRIDGE_FAST", "false"}});
  EXPECT_EQ(real.exit_code, 0) << real.err;
  EXPECT_THAT(real.out, HasSubstr("\nwaited 1"));  // not less than asked: 1000 ms and more
}

}  // namespace
}  // namespace eyebridge
