#include "kernel.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/base/jumping_clock.hpp"

namespace eyebridge::robios::classic {
namespace {

using std::chrono::milliseconds;
using ::testing::ElementsAre;

// Tasks are plain functions, which find what they need here.
Kernel* kernel = nullptr;
JumpingClock* robot_clock = nullptr;
std::vector<std::string> story;
sem* gate = nullptr;

// Those of all tests, for ever: tasks that were not ended wait in them.
auto& kept_clocks = *new std::vector<JumpingClock*>;
auto& kept_kernels = *new std::vector<Kernel*>;
auto& kept_gates = *new std::vector<sem*>;

void tell(const std::string& line) { story.push_back(line); }

/// A call of the API that takes `cost`.
void api_call(Time cost) {
  kernel->enter();
  robot_clock->spend(cost);
  kernel->leave();
}

std::string me() { return std::to_string(kernel->uid(nullptr).value()); }

void two_rounds() {
  for (int i = 0; i < 2; ++i) {
    tell(me());
    ASSERT_TRUE(kernel->reschedule());
  }
}

void computes() {
  for (int i = 0; i < 6; ++i) {
    tell(me());
    api_call(milliseconds(4));
  }
}

void takes_gate() {
  ASSERT_TRUE(kernel->take(*gate));
  tell(me());
  kernel->give(*gate);
}

void sleeps() {
  ASSERT_TRUE(kernel->sleep_until(milliseconds(10 * kernel->uid(nullptr).value())));
  tell(me());
}

void waits_for_ever() {
  for (;;) {
    tell(me());
    ASSERT_TRUE(kernel->suspend(nullptr));
  }
}

void ends_itself() {
  tell(me());
  static_cast<void>(kernel->kill(nullptr));
  tell("never");
}

class KernelTest : public ::testing::Test {
 protected:
  void SetUp() override {
    robot_clock = new JumpingClock;
    kernel =
        new Kernel(*robot_clock, {[](Time deadline) { robot_clock->wait_until(deadline); },
                                  []() -> std::optional<Time> { return {}; }, [] { return false; },
                                  [] { throw std::runtime_error("deadlock"); }});
    gate = new sem{};
    kept_clocks.push_back(robot_clock);
    kept_kernels.push_back(kernel);
    kept_gates.push_back(gate);
    story.clear();
  }

  /// Spawns a task and makes it ready.
  tcb* begin(void (*code)(), int uid, int priority = MIN_PRI) {
    tcb* const task = kernel->spawn("t", code, 4096, priority, uid).value();
    EXPECT_TRUE(kernel->ready(task));
    return task;
  }
};

TEST_F(KernelTest, CooperativeTasksTakeTurnsAndMainComesLast) {
  EXPECT_TRUE(kernel->start(false));
  EXPECT_FALSE(kernel->start(false));
  begin(two_rounds, 1);
  begin(two_rounds, 2);
  EXPECT_TRUE(kernel->reschedule());
  tell("main");
  EXPECT_THAT(story, ElementsAre("1", "2", "1", "2", "main"));
}

TEST_F(KernelTest, TheHigherPriorityRunsToItsEndFirst) {
  kernel->start(false);
  begin(two_rounds, 1);
  begin(two_rounds, 2, MAX_PRI);
  EXPECT_TRUE(kernel->reschedule());
  EXPECT_THAT(story, ElementsAre("2", "2", "1", "1"));
}

TEST_F(KernelTest, PreemptionTakesTheProcessorAfterATick) {
  kernel->start(true);
  begin(computes, 1);
  begin(computes, 2);
  EXPECT_TRUE(kernel->permit());
  tell("main");
  // Three calls of 4 ms are more than 10 ms: the next call comes after the other's turn.
  EXPECT_THAT(story,
              ElementsAre("1", "1", "1", "1", "2", "2", "2", "2", "1", "1", "2", "2", "main"));
}

TEST_F(KernelTest, NobodyIsPreemptedUnlessItIsPermitted) {
  kernel->start(true);
  begin(computes, 1);
  begin(computes, 2);
  EXPECT_TRUE(kernel->reschedule());
  EXPECT_THAT(story, ElementsAre("1", "1", "1", "1", "1", "1", "2", "2", "2", "2", "2", "2"));
}

TEST_F(KernelTest, NobodyIsPreemptedWhileItIsDisabled) {
  kernel->start(true);
  begin(computes, 1);
  begin(computes, 2);
  kernel->disable(true);
  EXPECT_TRUE(kernel->permit());
  EXPECT_THAT(story, ElementsAre("1", "1", "1", "1", "1", "1", "2", "2", "2", "2", "2", "2"));
}

TEST_F(KernelTest, PermissionNeedsThePreemptiveMode) {
  EXPECT_FALSE(kernel->permit());
  kernel->start(false);
  EXPECT_FALSE(kernel->permit());
}

TEST_F(KernelTest, ASemaphoreGoesToWhoWaitedLongest) {
  kernel->start(false);
  kernel->set(*gate, 0);
  begin(takes_gate, 1);
  begin(takes_gate, 2);
  begin(takes_gate, 3);
  EXPECT_TRUE(kernel->reschedule());
  EXPECT_EQ(gate->waitq.threads, 3);
  kernel->give(*gate);
  EXPECT_EQ(gate->waitq.threads, 2);
  EXPECT_TRUE(kernel->reschedule());
  EXPECT_THAT(story, ElementsAre("1", "2", "3"));
  EXPECT_EQ(gate->count, 1);
}

TEST_F(KernelTest, SleepersWakeInTheOrderOfTheirTimes) {
  kernel->start(false);
  begin(sleeps, 3);
  begin(sleeps, 1);
  begin(sleeps, 2);
  EXPECT_TRUE(kernel->sleep_until(milliseconds(25)));
  tell("main");
  EXPECT_TRUE(kernel->sleep_until(milliseconds(100)));
  EXPECT_THAT(story, ElementsAre("1", "2", "main", "3"));
  EXPECT_EQ(robot_clock->now(), milliseconds(100));
}

TEST_F(KernelTest, UnderPreemptionWhoWaitsGivesWay) {
  kernel->start(true);
  begin(computes, 1);
  EXPECT_TRUE(kernel->permit());
  story.clear();
  begin(computes, 2);
  kernel->enter();
  kernel->wait_until(robot_clock->now() + milliseconds(14));
  kernel->leave();
  tell("main");
  EXPECT_TRUE(kernel->reschedule());
  // main has waited, and so counts as one of the others: it goes on when the other's turn is over.
  EXPECT_THAT(story, ElementsAre("2", "2", "2", "2", "2", "2", "main"));
}

void never_waits() {
  for (int i = 0; i < 3000; ++i) api_call(milliseconds(4));
  tell("done");
}

TEST_F(KernelTest, MainIsNotStarvedForEver) {
  kernel->start(true);
  begin(never_waits, 1);
  EXPECT_TRUE(kernel->permit());
  tell("main");
  EXPECT_GE(robot_clock->now(), Kernel::kStarved);
  EXPECT_THAT(story, ElementsAre("main"));
}

TEST_F(KernelTest, ATaskCanBeSuspendedAndEnded) {
  kernel->start(false);
  tcb* const task = begin(waits_for_ever, 7);
  EXPECT_EQ(task->stat, TASK_READY);
  EXPECT_TRUE(kernel->reschedule());
  EXPECT_EQ(task->stat, TASK_SUSPEND);
  EXPECT_TRUE(kernel->ready(task));
  EXPECT_TRUE(kernel->suspend(task));
  EXPECT_TRUE(kernel->reschedule());
  EXPECT_THAT(story, ElementsAre("7"));
  EXPECT_TRUE(kernel->ready(task));
  EXPECT_TRUE(kernel->reschedule());
  EXPECT_THAT(story, ElementsAre("7", "7"));
  EXPECT_EQ(kernel->uid(task).value(), 7);
  EXPECT_TRUE(kernel->kill(task));
  EXPECT_FALSE(kernel->uid(task));
  EXPECT_FALSE(kernel->ready(task));
  EXPECT_TRUE(kernel->join(task));
}

TEST_F(KernelTest, ATaskThatEndsItselfDoesNotGoOn) {
  kernel->start(false);
  tcb* const task = begin(ends_itself, 5);
  EXPECT_TRUE(kernel->join(task));
  EXPECT_THAT(story, ElementsAre("5"));
}

TEST_F(KernelTest, WhatIsNoTaskIsAnError) {
  EXPECT_FALSE(kernel->reschedule());
  EXPECT_FALSE(kernel->spawn("t", computes, 0, MIN_PRI, 1));
  kernel->start(false);
  tcb nobody{};
  EXPECT_FALSE(kernel->ready(&nobody));
  EXPECT_FALSE(kernel->join(nullptr));
  EXPECT_EQ(kernel->uid(nullptr).value(), 0);
}

TEST_F(KernelTest, WaitingForWhatNobodyCanGiveIsADeadlock) {
  EXPECT_THROW(static_cast<void>(kernel->take(*gate)), std::runtime_error);
  kernel->start(false);
  EXPECT_THROW(static_cast<void>(kernel->take(*gate)), std::runtime_error);
}

}  // namespace
}  // namespace eyebridge::robios::classic
