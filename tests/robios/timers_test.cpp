#include "timers.hpp"

#include <algorithm>
#include <atomic>
#include <semaphore>
#include <thread>

#include <gtest/gtest.h>

#include "costs.hpp"

namespace eyebridge::robios {
namespace {

using std::chrono::milliseconds;

class VirtualClock final : public Clock {
 public:
  [[nodiscard]] Time now() const override { return now_; }
  void wait_until(Time deadline) override { now_ = std::max(now_, deadline); }
  void spend(Time cost) override { now_ += cost; }
  [[nodiscard]] bool is_virtual() const override { return true; }

 private:
  Time now_{0};
};

int calls = 0;
Timers* nested = nullptr;

TEST(Timers, CallsEveryPeriodFromTheMomentOfAttaching) {
  VirtualClock clock;
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

std::binary_semaphore callback_runs{0};
std::binary_semaphore callback_may_end{0};
std::atomic<bool> callback_ended = false;

TEST(Timers, FinishingWaitsForTheCallbackThatRuns) {
  VirtualClock clock;
  Timers timers(clock);
  timers.attach(milliseconds(10), [] {
    callback_runs.release();
    callback_may_end.acquire();
    callback_ended = true;
  });
  clock.wait_until(milliseconds(10));
  std::thread program([&] { timers.run_due(); });
  callback_runs.acquire();
  std::thread ending([&] {
    timers.finish();
    EXPECT_TRUE(callback_ended);
  });
  callback_may_end.release();
  program.join();
  ending.join();
  timers.run_due();
  EXPECT_FALSE(timers.next_due());
}

TEST(Timers, ALateTimerIsCalledOnceAndKeepsItsRhythm) {
  VirtualClock clock;
  Timers timers(clock);
  calls = 0;
  timers.attach(milliseconds(10), [] { ++calls; });
  clock.wait_until(milliseconds(35));
  timers.run_due();
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(timers.next_due(), milliseconds(40));
}

TEST(Timers, DetachingEndsTheCallsAndAnUnknownHandleIsRefused) {
  VirtualClock clock;
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
  VirtualClock clock;
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
  VirtualClock clock;
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
