// Who sends under a robot's identifiers, told by the order in which frames come.
#include "eyebridge/bridges/client/sender_watch.hpp"

#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "opcodes.h"

namespace eyebridge::bridges {
namespace {

using namespace std::chrono_literals;

constexpr std::array<int, 3> kFast = {EYECAN_S_POSE, EYECAN_S_SPEED, EYECAN_S_ENC12};

class SenderWatchTest : public ::testing::Test {
 protected:
  /// A frame, the robot's own or not; what of the three fast ones is known to be the robot's then
  /// is looked at.
  void frame(int function, bool is_own) {
    const bool is_usable = watch.heard(function, now);
    for (std::size_t i = 0; i < kFast.size(); ++i) {
      if (kFast[i] == function)
        pending[i] = is_usable ? (is_own ? Owner::Robot : Owner::Other) : Owner::None;
    }
    for (std::size_t i = 0; i < kFast.size(); ++i) {
      if (pending[i] == Owner::None || !watch.is_followed(kFast[i], now)) continue;
      ++(pending[i] == Owner::Robot ? own : foreign);
      pending[i] = Owner::None;
    }
    if (const auto found = watch.take_found()) named.push_back(*found);
  }
  /// A period of the robot, with a foreign frame before its `at`-th.
  void cycle(std::optional<int> other = {}, std::size_t at = 0) {
    for (std::size_t i = 0; i <= kFast.size(); ++i) {
      if (other && i == at) frame(*other, false);
      if (i < kFast.size() && kFast[i] != lost) frame(kFast[i], true);
    }
    now += 20ms;
  }

  enum class Owner { None, Robot, Other };
  SenderWatch watch;
  Time now{0};
  std::array<Owner, 3> pending{};
  int own = 0, foreign = 0;
  int lost = -1;
  std::vector<int> named;
};

TEST_F(SenderWatchTest, ARobotAloneIsHeardWithEachFrame) {
  for (int i = 0; i < 100; ++i) cycle();
  EXPECT_GE(own, 3 * 100 - 2);
  EXPECT_TRUE(named.empty());
}

TEST_F(SenderWatchTest, AForeignFrameIsNeverTakenWhereverItLies) {
  for (const int function : kFast) {
    for (std::size_t at = 0; at <= kFast.size(); ++at) {
      for (int i = 0; i < 100; ++i)
        cycle(i % 7 == 3 ? std::optional<int>(function) : std::nullopt, at);
    }
  }
  EXPECT_EQ(foreign, 0);
  EXPECT_GT(own, 2500);
}

TEST_F(SenderWatchTest, TheSecondSenderIsNamedWithinASecond) {
  for (int i = 0; i < 10; ++i) cycle();
  for (int i = 0; i < 50 && named.empty(); ++i) {
    cycle(i % 20 == 5 ? std::optional<int>(EYECAN_S_SPEED) : std::nullopt, 3);
  }
  ASSERT_EQ(named.size(), 1U);
  EXPECT_EQ(named.front(), EYECAN_S_SPEED);
  EXPECT_TRUE(watch.is_doubled(EYECAN_S_SPEED, now));
  EXPECT_FALSE(watch.is_doubled(EYECAN_S_POSE, now));
}

TEST_F(SenderWatchTest, OneThatSendsAsOftenLeavesNothingToTake) {
  for (int i = 0; i < 100; ++i) cycle(EYECAN_S_POSE, 3);
  EXPECT_EQ(foreign, 0);
  EXPECT_EQ(named, std::vector<int>{EYECAN_S_POSE});
}

TEST_F(SenderWatchTest, LostFramesAreNoSecondSender) {
  std::mt19937 random(1);
  for (int i = 0; i < 1000; ++i) {
    lost = random() % 20 == 0 ? kFast[random() % 3] : -1;
    cycle();
  }
  EXPECT_TRUE(named.empty());
  EXPECT_GT(own, 2700);
}

TEST_F(SenderWatchTest, FramesThatAreReadLateAreNoSecondSender) {
  for (int i = 0; i < 200; ++i) {
    cycle();
    now -= i % 50 == 49 ? -1s : 20ms;  // fifty periods at once
  }
  EXPECT_TRUE(named.empty());
  EXPECT_GT(own, 550);
}

TEST_F(SenderWatchTest, AForeignFrameThatIsReadFirstAfterAPauseIsNotTaken) {
  for (int i = 0; i < 100; ++i) {
    cycle();
    now += 500ms;  // the program was held up, and reads all that has come since
    frame(EYECAN_S_POSE, false);
    for (int old = 0; old < 25; ++old) {
      cycle();
      now -= 20ms;
    }
  }
  EXPECT_EQ(foreign, 0);
  EXPECT_GT(own, 7000);
}

TEST_F(SenderWatchTest, AnAnswerIsNoSecondSender) {
  for (int i = 0; i < 100; ++i) {
    watch.expect_another(EYECAN_S_POSE, now);
    frame(EYECAN_S_POSE, true);
    cycle();
    cycle();
  }
  EXPECT_TRUE(named.empty());
  EXPECT_GT(own, 500);
}

// An answer between two messages of a cycle looks like another sender's frame to the one after it.
TEST_F(SenderWatchTest, AnAnswerAmidACycleIsNoSecondSenderEither) {
  for (int i = 0; i < 100; ++i) {
    frame(EYECAN_S_POSE, true);
    frame(EYECAN_S_SPEED, true);
    frame(EYECAN_S_ENC12, true);
    watch.expect_another(EYECAN_S_SPEED, now);
    frame(EYECAN_S_SPEED, true);
    now += 20ms;
    cycle();
    watch.expect_another(EYECAN_S_SPEED, now);
    frame(EYECAN_S_POSE, true);
    frame(EYECAN_S_SPEED, true);
    frame(EYECAN_S_SPEED, true);
    frame(EYECAN_S_ENC12, true);
    now += 20ms;
  }
  EXPECT_TRUE(named.empty());
  EXPECT_GT(own, 700);
}

TEST_F(SenderWatchTest, WhatCannotBeTheAnswerIsAnotherSenders) {
  for (int i = 0; i < 3; ++i) cycle();
  watch.expect_another(EYECAN_S_SPEED, now);
  frame(EYECAN_S_POSE, true);
  frame(EYECAN_S_SPEED, true);
  EXPECT_FALSE(watch.heard(EYECAN_S_SPEED, now, false));
  EXPECT_TRUE(watch.heard(EYECAN_S_SPEED, now, true));
}

TEST_F(SenderWatchTest, ARobotThatLacksAMessageIsHeard) {
  lost = EYECAN_S_ENC12;
  for (int i = 0; i < 300; ++i) cycle();
  EXPECT_GT(own, 480);
  EXPECT_TRUE(named.empty());
}

TEST_F(SenderWatchTest, OneCommandOfAnotherHostIsForgivenTwoAreNot) {
  EXPECT_FALSE(watch.other_host(0s));
  EXPECT_FALSE(watch.other_host(5s));
  EXPECT_TRUE(watch.other_host(5s + 100ms));
}

}  // namespace
}  // namespace eyebridge::bridges
