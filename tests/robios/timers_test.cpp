#include "timers.hpp"

#include <gtest/gtest.h>

#include "costs.hpp"
#include "eyebridge/base/jumping_clock.hpp"

namespace eyebridge::robios {
namespace {

using std::chrono::milliseconds;

int calls = 0;
Timers* nested = nullptr;

TEST(Timers, CallsEveryPeriodFromTheMomentOfAttaching) {
  JumpingClock clock;
  clock.wait_until(milliseconds(7));
  Timers timers(clock);
  calls = 0;
  timers.attach(milliseconds(10), [] { ++calls; });
  EXPECT_EQ(timers.next_due(), milliseconds(17));
  clock.wait_until(milliseconds(16));
  timers.run_due();
  EXPECT_EQ(calls, 0);
  clock.wait_until(milliseconds(17));
  timers.run_due();
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(timers.next_due(), milliseconds(27));
}

TEST(Timers, ALateTimerIsCalledOnceAndKeepsItsRhythm) {
  JumpingClock clock;
  Timers timers(clock);
  calls = 0;
  timers.attach(milliseconds(10), [] { ++calls; });
  clock.wait_until(milliseconds(35));
  timers.run_due();
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(timers.next_due(), milliseconds(40));
}

TEST(Timers, DetachingEndsTheCallsAndAnUnknownHandleIsRefused) {
  JumpingClock clock;
  Timers timers(clock);
  calls = 0;
  const int handle = timers.attach(milliseconds(10), [] { ++calls; });
  EXPECT_TRUE(timers.detach(handle));
  EXPECT_FALSE(timers.detach(handle));
  clock.wait_until(milliseconds(100));
  timers.run_due();
  EXPECT_EQ(calls, 0);
  EXPECT_FALSE(timers.next_due());
}

TEST(Timers, ACallbackThatCallsTheApiDoesNotStartCallbacks) {
  JumpingClock clock;
  Timers timers(clock);
  calls = 0;
  nested = &timers;
  timers.attach(milliseconds(10), [] {
    ++calls;
    nested->run_due();
    EXPECT_FALSE(nested->next_due());
  });
  clock.wait_until(milliseconds(10));
  timers.run_due();
  EXPECT_EQ(calls, 1);
}

TEST(Timers, StoppedTimersCallNoMore) {
  JumpingClock clock;
  Timers timers(clock);
  calls = 0;
  timers.attach(milliseconds(10), [] { ++calls; });
  timers.stop();
  clock.wait_until(milliseconds(50));
  timers.run_due();
  EXPECT_EQ(calls, 0);
}

TEST(Costs, TheLongestPrefixOfACallDecides) {
  EXPECT_GT(cost_of("LCDImage"), cost_of("LCDPrintf"));
  EXPECT_LT(cost_of("LCDImageStart"), cost_of("LCDPrintf"));
  EXPECT_LT(cost_of("IPPRGB2Hue"), cost_of("IPSobel"));
  EXPECT_GT(cost_of("SomethingNew"), Time{0});
}

}  // namespace
}  // namespace eyebridge::robios
