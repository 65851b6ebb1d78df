#include "clock/real_time_clock.hpp"

#include <atomic>
#include <vector>

#include <gtest/gtest.h>

namespace eyebridge::hal {
namespace {

using namespace std::chrono_literals;

constexpr double kFast = 1000.0;  // one simulated second lasts a millisecond

TEST(RealTimeClock, HasSteppedTheWorldUpToTheDeadlineWhenAWaitEnds) {
  std::atomic<int> steps = 0;
  RealTimeClock clock(10ms, kFast, [&] { ++steps; });
  for (int i = 1; i <= 50; ++i) {
    const Time deadline = i * 37ms;
    clock.wait_until(deadline);
    EXPECT_GE(clock.now(), deadline);
    EXPECT_GE(steps, deadline / 10ms);
  }
}

TEST(RealTimeClock, NeverRunsAheadOfTheWorldByAStepOrMore) {
  std::atomic<int> steps = 0;
  RealTimeClock clock(10ms, kFast, [&] { ++steps; });
  for (int i = 0; i < 2000; ++i) {
    const Time now = clock.now();
    // Steps counted after the time was read: at least those that the time stands for.
    EXPECT_LT(now, (steps + 1) * 10ms);
  }
}

TEST(RealTimeClock, NeverRunsBackwards) {
  RealTimeClock clock(10ms, kFast, [] {});
  Time last{0};
  while (last < 2s) {
    const Time now = clock.now();
    ASSERT_GE(now, last);
    last = now;
  }
}

TEST(RealTimeClock, KnowsWhatItShowedAtAMomentOfTheComputersClock) {
  const auto computer = [] { return Time(std::chrono::steady_clock::now().time_since_epoch()); };
  RealTimeClock clock(10s, 10.0, [] {});  // steps that last a second: none slips
  clock.wait_until(50ms);
  const Time before = clock.now();
  const Time moment = computer();
  const Time after = clock.now();
  clock.wait_until(after + 50ms);
  EXPECT_GE(clock.at(moment), before);
  EXPECT_LE(clock.at(moment), after);
  EXPECT_EQ(clock.at(moment) - clock.at(moment - 1us), 10us);
  clock.pause();
  EXPECT_EQ(clock.at(computer()), clock.now()) << "it stands still";
}

TEST(RealTimeClock, ReturnsAtOnceFromADeadlineThatHasPassed) {
  RealTimeClock clock(10ms, kFast, [] {});
  clock.wait_until(1s);
  clock.wait_until(10ms);
  clock.wait_until(-5s);
  EXPECT_GE(clock.now(), 1s);
}

TEST(RealTimeClock, LetsSeveralThreadsWait) {
  std::atomic<int> steps = 0;
  RealTimeClock clock(10ms, kFast, [&] { ++steps; });
  std::vector<std::thread> threads;
  for (int i = 1; i <= 4; ++i) {
    threads.emplace_back([&clock, &steps, i] {
      for (Time deadline = i * 10ms; deadline < 1s; deadline += i * 10ms) {
        clock.wait_until(deadline);
        EXPECT_GE(steps, deadline / 10ms);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
}

TEST(RealTimeClock, StandsStillWhilePaused) {
  std::atomic<int> steps = 0;
  RealTimeClock clock(10ms, kFast, [&] { ++steps; });
  clock.wait_until(100ms);
  clock.pause();
  const Time paused = clock.now();
  RealTimeClock other(10ms, kFast, [] {});
  other.wait_until(2s);  // another clock's time passes meanwhile
  EXPECT_EQ(clock.now(), paused);

  std::thread waiter([&] { clock.wait_until(paused + 50ms); });
  clock.resume();
  waiter.join();
  EXPECT_GE(clock.now(), paused + 50ms);
}

TEST(RealTimeClock, SlipsInsteadOfHeapingUpStepsWhenTheWorldIsSlow) {
  // Each step takes a millisecond of wall time but stands for ten seconds' worth of clock.
  RealTimeClock pace(1ms, 1.0, [] {});
  std::atomic<int> steps = 0;
  RealTimeClock clock(1ms, 1e4, [&] {
    ++steps;
    pace.wait_until(pace.now() + 1ms);
  });
  while (clock.overruns() < 3) clock.wait_until(clock.now() + 1ms);
  const Time now = clock.now();
  EXPECT_LT(now, (steps + 1) * 1ms);
  EXPECT_FALSE(clock.is_virtual());
}

TEST(RealTimeClock, DoesNothingWhenACallIsCharged) {
  RealTimeClock clock(10ms, kFast, [] {});
  clock.pause();
  const Time before = clock.now();
  clock.spend(10s);
  EXPECT_EQ(clock.now(), before);
}

}  // namespace
}  // namespace eyebridge::hal
