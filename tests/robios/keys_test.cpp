#include "keys.hpp"

#include <atomic>
#include <thread>

#include <gtest/gtest.h>

namespace eyebridge::robios {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr int kAnyKey = -1;

class FakeClock final : public Clock {
 public:
  explicit FakeClock(bool is_virtual = true) : virtual_(is_virtual) {}
  [[nodiscard]] Time now() const override { return now_.load(); }
  void wait_until(Time deadline) override {
    if (deadline > now_.load()) {
      now_ = deadline;
    }
  }
  void spend(Time cost) override { now_ = now_.load() + cost; }
  [[nodiscard]] bool is_virtual() const override { return virtual_; }

 private:
  std::atomic<Time> now_{Time{0}};
  bool virtual_;
};

/// Gives its keys one by one, then ends or stays silent.
class FakeInput final : public KeyInput {
 public:
  FakeInput(std::deque<int> keys, bool ends) : keys_(std::move(keys)), ends_(ends) {}
  KeyEvent poll(milliseconds) override {
    if (keys_.empty()) {
      return {};
    }
    const int key = keys_.front();
    keys_.pop_front();
    // A key beyond the four is a touch in this test, a negative one of the remote control.
    if (key < 0) return {0, std::nullopt, -key};
    return key <= 8 ? KeyEvent{key, std::nullopt} : KeyEvent{0, TouchPoint{key, key}};
  }
  [[nodiscard]] bool has_touches() const override { return has_touches_; }
  void give_touches() { has_touches_ = true; }
  [[nodiscard]] bool open() const override { return !(ends_ && keys_.empty()); }

 private:
  std::deque<int> keys_;
  bool ends_;
  bool has_touches_ = false;
};

Keys::WaitUntil on(FakeClock& clock) {
  return [&clock](Time deadline) { clock.wait_until(deadline); };
}

TEST(KeysRead, ReportsEachPressOnceInOrder) {
  FakeClock clock;
  Keys keys(clock, {}, nullptr);
  EXPECT_EQ(keys.read(), 0);
  keys.press(4);
  keys.press(1);
  EXPECT_EQ(keys.read(), 4);
  EXPECT_EQ(keys.read(), 1);
  EXPECT_EQ(keys.read(), 0);
}

TEST(KeysRead, IgnoresWhatIsNoKey) {
  FakeClock clock;
  Keys keys(clock, {}, nullptr);
  for (const int key : {0, 3, 16, -1}) {
    keys.press(key);
  }
  EXPECT_EQ(keys.read(), 0);
}

TEST(KeysRead, FollowsTheScriptOnTheClock) {
  FakeClock clock;
  Keys keys(clock, parse_key_script("KEY1@2s,KEY4@10s"), nullptr);
  EXPECT_EQ(keys.read(), 0);
  clock.spend(milliseconds(1999));
  EXPECT_EQ(keys.read(), 0);
  clock.spend(milliseconds(1));
  EXPECT_EQ(keys.read(), 1);
  EXPECT_EQ(keys.read(), 0);
  clock.spend(seconds(60));
  EXPECT_EQ(keys.read(), 8);
}

TEST(KeysWait, JumpsToTheScriptedKey) {
  FakeClock clock;
  Keys keys(clock, parse_key_script("KEY1@2s,KEY4@10s"), nullptr);
  EXPECT_EQ(keys.wait(kAnyKey, on(clock)).value(), 1);
  EXPECT_EQ(clock.now(), seconds(2));
  EXPECT_EQ(keys.wait(kAnyKey, on(clock)).value(), 8);
  EXPECT_EQ(clock.now(), seconds(10));
}

TEST(KeysWait, DropsKeysThatAreNotWaitedFor) {
  FakeClock clock;
  Keys keys(clock, parse_key_script("KEY1@1s,KEY2@2s,KEY4@3s"), nullptr);
  EXPECT_EQ(keys.wait(8 | 4, on(clock)).value(), 8);
  EXPECT_EQ(clock.now(), seconds(3));
  EXPECT_EQ(keys.read(), 0);
}

TEST(KeysWait, TakesAPressThatWasNotReportedYet) {
  FakeClock clock;
  Keys keys(clock, {}, nullptr);
  keys.press(2);
  EXPECT_EQ(keys.wait(kAnyKey, on(clock)).value(), 2);
  EXPECT_EQ(clock.now(), Time{0});
}

TEST(KeysWait, WorksOnARealClockToo) {
  FakeClock clock(false);
  Keys keys(clock, parse_key_script("KEY3@2s"), nullptr);
  EXPECT_EQ(keys.wait(kAnyKey, on(clock)).value(), 4);
  EXPECT_EQ(clock.now(), seconds(2));
}

TEST(KeysWait, FailsWhenNoKeyCanEverCome) {
  for (const bool is_virtual : {true, false}) {
    FakeClock clock(is_virtual);
    Keys keys(clock, parse_key_script("KEY1@1s"), nullptr);
    const auto key = keys.wait(2, on(clock));
    ASSERT_FALSE(key);
    EXPECT_EQ(key.error().code, Errc::Unsupported);
    EXPECT_NE(key.error().what.find("--keys"), std::string::npos);
  }
}

TEST(KeysWait, RefusesAMaskWithoutAKey) {
  FakeClock clock;
  Keys keys(clock, parse_key_script("KEY1@1s"), nullptr);
  EXPECT_EQ(keys.wait(0, on(clock)).error().what, "key mask 0, expected KEY1..KEY4");
  EXPECT_EQ(keys.wait(16, on(clock)).error().code, Errc::OutOfRange);
}

TEST(KeysWait, AsksTheTerminalWhenTheScriptIsUsedUp) {
  for (const bool is_virtual : {true, false}) {
    FakeClock clock(is_virtual);
    Keys keys(clock, parse_key_script("KEY1@1s"),
              std::make_unique<FakeInput>(std::deque<int>{0, 0, 2}, false));
    EXPECT_EQ(keys.wait(2, on(clock)).value(), 2);
  }
}

TEST(KeysWait, FailsWhenTheTerminalEnds) {
  FakeClock clock(false);
  Keys keys(clock, {}, std::make_unique<FakeInput>(std::deque<int>{1}, true));
  EXPECT_EQ(keys.wait(8, on(clock)).error().code, Errc::Unsupported);
}

TEST(KeysWait, VirtualTimeStandsStillForAPersonAtAWindow) {
  FakeClock clock;
  Keys keys(clock, {}, nullptr);
  keys.set_window(true);
  std::thread person([&keys] { keys.press(8); });
  EXPECT_EQ(keys.wait(kAnyKey, on(clock)).value(), 8);
  person.join();
  EXPECT_EQ(clock.now(), Time{0});
}

TEST(KeysWait, EndsWhenTheWindowIsClosed) {
  FakeClock clock;
  Keys keys(clock, {}, nullptr);
  keys.set_window(true);
  std::thread person([&keys] { keys.set_window(false); });
  EXPECT_EQ(keys.wait(kAnyKey, on(clock)).error().code, Errc::Unsupported);
  person.join();
}

TEST(KeysTouch, OnASoftKeyIsThatKeyAndATouch) {
  FakeClock clock;
  Keys keys(clock, {}, nullptr);
  keys.set_touch_map([](int x, int y) { return y >= 362 && x < 140 ? 1 : 0; });
  keys.touch(10, 380);
  EXPECT_EQ(keys.read(), 1);
  EXPECT_EQ(keys.read_touch(), (TouchPoint{10, 380}));
  keys.touch(10, 20);
  EXPECT_EQ(keys.read(), 0);
  EXPECT_EQ(keys.read_touch(), (TouchPoint{10, 20}));
  EXPECT_EQ(keys.read_touch(), std::nullopt);
}

TEST(KeysTouch, ComesFromATerminalThatHasThem) {
  for (const bool is_virtual : {true, false}) {
    FakeClock clock(is_virtual);
    auto input = std::make_unique<FakeInput>(std::deque<int>{0, 60}, false);
    input->give_touches();
    Keys keys(clock, {}, std::move(input));
    keys.set_touch_map([](int x, int) { return x == 60 ? 2 : 0; });
    EXPECT_EQ(keys.wait_touch(on(clock)).value(), (TouchPoint{60, 60}));
    EXPECT_EQ(keys.read_touch(), std::nullopt);
    EXPECT_EQ(keys.read(), 2) << "a soft key was under it";
  }
}

TEST(KeysTouch, IsNotWaitedForAtATerminalThatHasNone) {
  FakeClock clock;
  Keys keys(clock, {}, std::make_unique<FakeInput>(std::deque<int>{1}, false));
  const auto touch = keys.wait_touch(on(clock));
  ASSERT_FALSE(touch);
  EXPECT_EQ(touch.error().code, Errc::Unsupported);
}

TEST(KeysTouch, IsScriptedAndWaitedFor) {
  FakeClock clock;
  Keys keys(clock, parse_key_script("KEY1@1s,30:40@2s"), nullptr);
  EXPECT_EQ(keys.wait_touch(on(clock)).value(), (TouchPoint{30, 40}));
  EXPECT_EQ(clock.now(), seconds(2));
  EXPECT_EQ(keys.read(), 1);
  EXPECT_EQ(keys.wait_touch(on(clock)).error().code, Errc::Unsupported);
}

TEST(KeysRemote, WhatIsTypedCountsOnceTheProgramAsksForTheRemote) {
  FakeClock clock(false);
  Keys keys(clock, {}, std::make_unique<FakeInput>(std::deque<int>{-'5', -'R', 2, -'O'}, true));
  EXPECT_EQ(keys.read(), 0) << "5, of no use to this program yet";
  EXPECT_EQ(keys.read_remote(), 'R');
  EXPECT_EQ(keys.wait_remote(on(clock)).value(), 'O');
  EXPECT_EQ(keys.read(), 2);
  EXPECT_EQ(keys.wait_remote(on(clock)).error().code, Errc::Unsupported) << "the terminal is gone";
}

TEST(KeysRemote, CodesWaitApartFromKeysUntilTheyAreAskedFor) {
  FakeClock clock;
  Keys keys(clock, parse_key_script("IRTV_1@1s,KEY1@1s,IRTV_2@2s,IRTV_3@5s"), nullptr);
  EXPECT_EQ(keys.read_remote(), 0);
  EXPECT_EQ(keys.wait_remote(on(clock)).value(), '1');
  EXPECT_EQ(clock.now(), seconds(1));
  clock.wait_until(seconds(2));
  EXPECT_EQ(keys.read(), 1);
  EXPECT_EQ(keys.read(), 0);
  EXPECT_EQ(keys.read_remote(), '2');
  keys.press_remote(77);
  keys.press_remote(0);
  keys.press_remote(256);
  EXPECT_EQ(keys.read_remote(), 77);
  clock.wait_until(seconds(6));
  keys.flush_remote();
  EXPECT_EQ(keys.read_remote(), 0);
  EXPECT_EQ(keys.wait_remote(on(clock)).error().code, Errc::Unsupported);
}

TEST(KeysGiven, TellWhatTheProgramGotLastAndWhen) {
  FakeClock clock;
  Keys keys(clock, parse_key_script("KEY2@1s,30:40@2s,IRTV_5@3s"), nullptr);
  EXPECT_EQ(keys.given().key, 0);
  EXPECT_FALSE(keys.given().touch);
  clock.wait_until(seconds(4));
  EXPECT_EQ(keys.given().key, 0) << "the program has not asked yet";
  EXPECT_EQ(keys.read(), 2);
  EXPECT_EQ(keys.given().key, 2);
  EXPECT_EQ(keys.given().key_at, seconds(4));
  clock.wait_until(seconds(5));
  EXPECT_TRUE(keys.read_touch());
  EXPECT_EQ(keys.given().touch, (TouchPoint{30, 40}));
  EXPECT_EQ(keys.given().touch_at, seconds(5));
  EXPECT_EQ(keys.read_remote(), '5');
  EXPECT_EQ(keys.given().remote, '5');
  EXPECT_EQ(keys.read(), 0);
  EXPECT_EQ(keys.given().key, 2) << "that there was none is no news";
}

TEST(KeysGiven, OfAWaitIsTheKeyThatItWaitedFor) {
  FakeClock clock;
  Keys keys(clock, {}, nullptr);
  keys.press(1);
  keys.press(4);
  EXPECT_EQ(keys.wait(4, [](Time) {}).value(), 4);
  EXPECT_EQ(keys.given().key, 4);
}

}  // namespace
}  // namespace eyebridge::robios
