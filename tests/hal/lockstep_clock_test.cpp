#include "clock/lockstep_clock.hpp"

#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace eyebridge::hal {
namespace {

using namespace std::chrono_literals;

TEST(LockstepClock, StepsTheWorldOncePerStepOfTime) {
  int steps = 0;
  LockstepClock clock(10ms, [&] { ++steps; });
  clock.wait_until(9999us);
  EXPECT_EQ(steps, 0);
  clock.wait_until(10ms);
  EXPECT_EQ(steps, 1);
  clock.wait_until(1s);
  EXPECT_EQ(steps, 100);
  EXPECT_EQ(clock.now(), 1s);
}

TEST(LockstepClock, EndsAWaitExactlyAtItsDeadline) {
  LockstepClock clock(10ms, [] {});
  clock.wait_until(12345us);
  EXPECT_EQ(clock.now(), 12345us);
}

TEST(LockstepClock, NeverRunsBackwards) {
  int steps = 0;
  LockstepClock clock(10ms, [&] { ++steps; });
  clock.wait_until(50ms);
  clock.wait_until(20ms);
  clock.spend(-1s);
  EXPECT_EQ(clock.now(), 50ms);
  EXPECT_EQ(steps, 5);
}

TEST(LockstepClock, AddsUpWhatCallsCost) {
  int steps = 0;
  LockstepClock clock(10ms, [&] { ++steps; });
  for (int i = 0; i < 1000; ++i) clock.spend(25us);
  EXPECT_EQ(clock.now(), 25ms);
  EXPECT_EQ(steps, 2);
}

TEST(LockstepClock, ShowsTheTimeOfTheStepThatIsUnderWay) {
  std::vector<Time> times;
  LockstepClock* clock = nullptr;
  LockstepClock stepping(10ms, [&] { times.push_back(clock->now()); });
  clock = &stepping;
  stepping.wait_until(35ms);
  EXPECT_EQ(times, (std::vector<Time>{0ms, 10ms, 20ms}));
  EXPECT_TRUE(stepping.is_virtual());
}

TEST(LockstepClock, DoesNotRepeatAStepThatThrew) {
  int steps = 0;
  LockstepClock clock(10ms, [&] {
    if (++steps == 2) throw std::runtime_error("full disk");
  });
  EXPECT_THROW(clock.wait_until(50ms), std::runtime_error);
  clock.wait_until(50ms);
  EXPECT_EQ(steps, 5);
  EXPECT_EQ(clock.now(), 50ms);
}

}  // namespace
}  // namespace eyebridge::hal
