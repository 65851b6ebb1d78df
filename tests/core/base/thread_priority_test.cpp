#include "eyebridge/base/thread_priority.hpp"

#include <thread>

#include <gtest/gtest.h>
#include <sched.h>

namespace eyebridge {
namespace {

using Kind = ThreadPriority::Kind;

/// A system that grants what it is told to, at these levels or below.
PriorityCalls granting(int most_real_time, int least_nice) {
  return {[=](int level) { return level <= most_real_time; },
          [=](int level) { return level >= least_nice; }};
}

TEST(ThreadPriority, TheLowestRealTimePriorityIsTakenWhereItIsPermitted) {
  const ThreadPriority granted = raise_priority(granting(1, -20));
  EXPECT_EQ(granted.kind, Kind::RealTime);
  EXPECT_EQ(granted.str(), "real-time priority 1");
}

TEST(ThreadPriority, ANegativeNiceValueIsTheNextBest) {
  const ThreadPriority granted = raise_priority(granting(0, -20));
  EXPECT_EQ(granted.kind, Kind::Nice);
  EXPECT_EQ(granted.str(), "nice -10");
}

TEST(ThreadPriority, WhereNothingIsPermittedTheThreadStaysOrdinary) {
  const ThreadPriority granted = raise_priority(granting(0, 0));
  EXPECT_EQ(granted.kind, Kind::Ordinary);
  EXPECT_EQ(granted.str(), "ordinary priority");
}

// Whatever this machine permits: what is told is what the kernel then says.
TEST(ThreadPriority, ThatOfAThreadIsWhatWasTold) {
  std::thread([] {
    const ThreadPriority granted = raise_priority();
    const int policy = sched_getscheduler(0) & ~SCHED_RESET_ON_FORK;
    EXPECT_EQ(policy == SCHED_RR, granted.kind == Kind::RealTime);
    restore_priority(granted);
    EXPECT_EQ(sched_getscheduler(0) & ~SCHED_RESET_ON_FORK, SCHED_OTHER);
  }).join();
  EXPECT_EQ(sched_getscheduler(0), SCHED_OTHER);
}

}  // namespace
}  // namespace eyebridge
