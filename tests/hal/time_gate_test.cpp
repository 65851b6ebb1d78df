#include "clock/time_gate.hpp"

#include <atomic>
#include <limits>
#include <thread>

#include <gtest/gtest.h>

#include "clock/lockstep_clock.hpp"
#include "clock/real_time_clock.hpp"

namespace eyebridge::hal {
namespace {

using namespace std::chrono_literals;

/// A world in virtual time that only counts its steps, and a program that waits in it.
struct GatedWorld {
  std::atomic<int> steps = 0;
  TimeGate gate{10ms};
  LockstepClock clock{10ms, [this] {
                        gate.pass();
                        ++steps;
                      }};
  void await(int wanted) const {
    while (steps < wanted) std::this_thread::yield();
  }
};

/// Another clock's time passes.
void meanwhile() {
  RealTimeClock(10ms, 1000.0, [] {}).wait_until(20s);
}

TEST(TimeGate, LetsPassAsLongAsNobodyPauses) {
  GatedWorld world;
  EXPECT_FALSE(world.gate.is_paused());
  EXPECT_EQ(world.gate.factor(), TimeControl::kFastest);
  world.clock.wait_until(1000s);
  EXPECT_EQ(world.steps, 100'000);
}

TEST(TimeGate, StandsStillWhilePausedAndMakesSingleSteps) {
  GatedWorld world;
  world.gate.step();  // nothing, as it is not paused
  world.gate.pause();
  std::thread program([&] { world.clock.wait_until(100ms); });
  meanwhile();
  EXPECT_EQ(world.steps, 0);
  EXPECT_EQ(world.clock.now(), 0ms);
  world.gate.step();
  world.gate.step();
  world.await(2);
  meanwhile();
  EXPECT_EQ(world.steps, 2);
  world.gate.resume();
  program.join();
  EXPECT_EQ(world.clock.now(), 100ms);
  EXPECT_EQ(world.steps, 10);
}

TEST(TimeGate, KeepsToItsFactor) {
  GatedWorld world;
  const auto start = std::chrono::steady_clock::now();
  ASSERT_TRUE(world.gate.set_factor(10.0));
  EXPECT_EQ(world.gate.factor(), 10.0);
  world.clock.wait_until(1s);
  // Not less: how much more is the computer's affair.
  EXPECT_GE(std::chrono::steady_clock::now() - start, 99ms);
  ASSERT_TRUE(world.gate.set_factor(TimeControl::kFastest));
  world.clock.wait_until(1000s);
}

TEST(TimeGate, WhatIsNoFactorIsRefused) {
  GatedWorld world;
  for (const double bad : {0.0, -1.0, 1e7, std::numeric_limits<double>::quiet_NaN()}) {
    const Result<void> result = world.gate.set_factor(bad);
    ASSERT_FALSE(result) << bad;
    EXPECT_EQ(result.error().code, Errc::OutOfRange);
  }
  EXPECT_EQ(world.gate.factor(), TimeControl::kFastest);
}

TEST(RealTimeControl, MakesSingleStepsWhilePaused) {
  std::atomic<int> steps = 0;
  RealTimeClock clock(
      10ms, 1000.0, [&] { ++steps; }, RealTimeClock::Start::Later);
  clock.resume();
  EXPECT_EQ(clock.now(), 0ms) << "it has not begun";
  EXPECT_FALSE(clock.is_paused());
  clock.pause();
  clock.begin();
  EXPECT_TRUE(clock.is_paused());
  meanwhile();
  EXPECT_EQ(clock.now(), 0ms) << "it has begun, but is paused";
  std::thread program([&] { clock.wait_until(25ms); });
  for (int i = 1; i <= 3; ++i) {
    clock.step();
    while (steps < i) std::this_thread::yield();
  }
  program.join();
  EXPECT_EQ(steps, 3);
  EXPECT_EQ(clock.now(), 30ms);
  clock.resume();
  clock.wait_until(1s);
}

TEST(RealTimeControl, ChangesItsFactorWithoutAJump) {
  RealTimeClock clock(10ms, 1.0, [] {});
  const Time before = clock.now();
  ASSERT_TRUE(clock.set_factor(1e6));
  clock.wait_until(before + 100s);  // a minute and more at the old factor
  ASSERT_TRUE(clock.set_factor(0.001));
  EXPECT_EQ(clock.factor(), 0.001);
  const Time slow = clock.now();
  meanwhile();
  EXPECT_LT(clock.now() - slow, 1s);
  EXPECT_FALSE(clock.set_factor(TimeControl::kFastest)) << "time is real here";
  EXPECT_FALSE(clock.set_factor(0.0));
}

}  // namespace
}  // namespace eyebridge::hal
