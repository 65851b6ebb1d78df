#include "thread_turns.hpp"

#include <atomic>
#include <chrono>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

namespace eyebridge::robios {
namespace {

using std::chrono::milliseconds;
using Member = ThreadTurns::Member;
using Kind = ThreadState::Kind;

/// Virtual time that nobody but the one whose turn it is lets pass.
class PlainClock final : public Clock {
 public:
  [[nodiscard]] Time now() const override { return Time(now_.load()); }
  void wait_until(Time deadline) override {
    if (deadline == fails_at) throw std::runtime_error("the world ends");
    if (deadline > now()) now_ = deadline.count();
  }
  void spend(Time cost) override { wait_until(now() + cost); }
  [[nodiscard]] bool is_virtual() const override { return true; }

  Time fails_at{-1};

 private:
  std::atomic<Time::rep> now_ = 0;
};

/// Threads that write into one text: what they do is in turns, or the sanitizer says so.
struct Stage {
  PlainClock clock;
  std::function<ThreadState(Member&)> look = [](Member&) { return ThreadState{}; };
  int told = 0;
  ThreadTurns turns{[this](Member& member) { return look(member); }, [this] { ++told; }};
  Member* me = nullptr;
  std::string text;
  std::vector<std::thread> threads;

  Stage() {
    me = &turns.adopt(1);
    turns.begin(clock);
  }
  Member& add(const std::function<void(Member&)>& body) {
    Member& member = turns.expect();
    threads.emplace_back([this, &member, body] {
      member.tid = 2;
      turns.start(member);
      body(member);
      turns.leave(member);
    });
    return member;
  }
  /// One that writes `name` and waits, `times` times.
  Member& add(char name, Time pause, int times) {
    return add([=, this](Member& member) {
      for (int i = 0; i < times; ++i) {
        text += name;
        turns.wait(member, clock.now() + pause);
      }
    });
  }
  /// The main thread waits for the end of all.
  std::string run() {
    turns.leave(*me);
    for (std::thread& thread : threads) thread.join();
    return text;
  }
};

TEST(ThreadTurns, LetTimePassForAllAtOnce) {
  Stage stage;
  stage.add('a', milliseconds(10), 100);
  stage.add('b', milliseconds(10), 100);
  stage.run();
  EXPECT_EQ(stage.clock.now(), milliseconds(1000));
}

TEST(ThreadTurns, GoOnInTheOrderOfTimeThenOfTheirBirth) {
  Stage stage;
  stage.add('a', milliseconds(30), 3);
  stage.add('b', milliseconds(10), 6);
  stage.add('c', milliseconds(20), 3);
  // At 20, 30, 40 and 60 two are due.
  EXPECT_EQ(stage.run(), "abcbbcabbcba");
}

TEST(ThreadTurns, BeginWhenTheirMakerGivesWay) {
  Stage stage;
  stage.add('a', milliseconds(10), 1);
  stage.text += "made ";
  stage.turns.wait(*stage.me, milliseconds(5));
  stage.text += " 5";
  EXPECT_EQ(stage.run(), "made a 5");
}

TEST(ThreadTurns, WakeWhoParkedFirst) {
  Stage stage;
  const int what = 0;
  const auto sleeper = [&](char name) {
    stage.add([&stage, &what, name](Member& member) {
      const bool is_late = stage.turns.park(member, &what, ThreadTurns::kNever);
      stage.text += name;
      EXPECT_FALSE(is_late);
      EXPECT_EQ(stage.clock.now(), milliseconds(name == 'a' ? 10 : 20));
    });
  };
  for (const char name : {'a', 'b', 'c'}) sleeper(name);
  stage.turns.wait(*stage.me, milliseconds(10));
  stage.turns.wake(&what, false);
  stage.turns.wait(*stage.me, milliseconds(20));
  stage.text += "|";
  stage.turns.wake(&what, true);
  EXPECT_EQ(stage.run(), "a|bc");
}

TEST(ThreadTurns, EndAParkAtItsDeadline) {
  Stage stage;
  const int what = 0;
  stage.add([&](Member& member) {
    EXPECT_TRUE(stage.turns.park(member, &what, milliseconds(30)));
    EXPECT_EQ(stage.clock.now(), milliseconds(30));
    stage.turns.wake(&what, true);  // nobody is there
  });
  stage.add('b', milliseconds(20), 3);
  EXPECT_EQ(stage.run(), "bbb");
}

TEST(ThreadTurns, WaitForAnEnd) {
  Stage stage;
  Member& first = stage.add('a', milliseconds(10), 3);
  stage.add('b', milliseconds(10), 5);
  stage.turns.name(first, 77);
  EXPECT_EQ(stage.turns.await_end(*stage.me, 77, milliseconds(20)), ThreadTurns::Ended::Late);
  EXPECT_EQ(stage.turns.await_end(*stage.me, 77), ThreadTurns::Ended::Yes);
  EXPECT_EQ(stage.turns.await_end(*stage.me, 77), ThreadTurns::Ended::Unknown);
  EXPECT_EQ(stage.clock.now(), milliseconds(30));
  stage.text += '.';
  EXPECT_EQ(stage.run().substr(0, 7), "ababab.");
}

TEST(ThreadTurns, HoldTimeUpWhileOneComputes) {
  Stage stage;
  int looks = 0;
  stage.look = [&](Member& member) -> ThreadState {
    EXPECT_EQ(&member, stage.me);
    return {++looks < 5 ? Kind::Computes : Kind::Sleeps};
  };
  stage.add([&](Member& member) {
    stage.turns.wait(member, milliseconds(10));
    EXPECT_EQ(looks, 6);  // five before its first turn, one now
    stage.turns.wait(member, milliseconds(20));
  });
  for (std::thread& thread : stage.threads) thread.join();
  EXPECT_EQ(stage.clock.now(), milliseconds(20));
  EXPECT_EQ(stage.told, 0);
}

// Who waits for the table's lock sleeps, too, but is about to wait for an earlier moment.
TEST(ThreadTurns, WaitForWhoIsComing) {
  Stage stage;
  Member& coming = stage.turns.adopt(2);
  stage.look = [&](Member& member) -> ThreadState {
    EXPECT_EQ(&member, &coming);
    if (!stage.threads.empty()) return {Kind::Sleeps};
    std::atomic<int> tid = 0;
    stage.threads.emplace_back([&] {
      tid = gettid();
      stage.turns.wait(coming, milliseconds(5));
      stage.text += 'a';
      stage.turns.leave(coming);
    });
    while (tid == 0) std::this_thread::yield();
    while (look_at_thread(tid).kind != Kind::Sleeps) std::this_thread::yield();
    return {Kind::Sleeps};
  };
  stage.turns.wait(*stage.me, milliseconds(10));
  stage.text += 'b';
  EXPECT_EQ(stage.run(), "ab");
}

// Its answer comes by itself, and it goes on before the others do.
TEST(ThreadTurns, WaitForWhoSleepsInACall) {
  Stage stage;
  Member& asking = stage.turns.adopt(2);
  asking.is_in_call = true;
  std::atomic<bool> was_seen = false;
  stage.look = [&](Member& member) -> ThreadState {
    // Between its call's end and its wait it computes, and may be looked at.
    EXPECT_TRUE(&member != &asking || !asking.is_in_call);
    was_seen = true;
    return {&member == &asking ? Kind::Computes : Kind::Sleeps};
  };
  stage.add('b', milliseconds(10), 1);
  while (!was_seen) std::this_thread::yield();
  EXPECT_EQ(stage.text, "");
  asking.is_in_call = false;
  stage.turns.wait(asking, milliseconds(5));
  stage.text += 'a';
  stage.turns.leave(asking);
  EXPECT_EQ(stage.run(), "ba");
}

TEST(ThreadTurns, LetWhoWasPassedComeBackInTurn) {
  Stage stage;
  stage.look = [&](Member& member) -> ThreadState {
    return {&member == stage.me ? Kind::Sleeps : Kind::Computes};
  };
  stage.turns.come_back(*stage.me);  // nobody has passed it: at once
  std::atomic<bool> has_passed = false;
  stage.add([&](Member& member) {
    has_passed = true;
    while (stage.me->stage != Member::Stage::Waiting) std::this_thread::yield();
    stage.text += 'a';
    stage.turns.wait(member, milliseconds(5));
    stage.text += 'b';
  });
  while (!has_passed) std::this_thread::yield();
  stage.turns.come_back(*stage.me);
  stage.text += '.';
  EXPECT_EQ(stage.run(), "a.b");
}

TEST(ThreadTurns, GoOnWithoutWhoComputesForLong) {
  Stage stage;
  double processor_s = 1.0;
  stage.look = [&](Member&) -> ThreadState {
    return {Kind::Computes, std::exchange(processor_s, processor_s + 2.0)};
  };
  stage.add('a', milliseconds(10), 3);
  for (std::thread& thread : stage.threads) thread.join();
  EXPECT_EQ(stage.clock.now(), milliseconds(30));
  EXPECT_EQ(stage.told, 1);
  // When it calls again it is one of them again.
  stage.turns.wait(*stage.me, milliseconds(40));
  EXPECT_EQ(stage.clock.now(), milliseconds(40));
}

TEST(ThreadTurns, ForgetWhoIsGone) {
  Stage stage;
  stage.look = [](Member&) -> ThreadState { return {Kind::Gone}; };
  stage.add('a', milliseconds(10), 3);
  for (std::thread& thread : stage.threads) thread.join();
  EXPECT_EQ(stage.text, "aaa");
  EXPECT_TRUE(stage.turns.is_alone());
}

TEST(ThreadTurns, GoOnAfterAStepThatFails) {
  Stage stage;
  stage.clock.fails_at = milliseconds(10);
  stage.add([&](Member& member) {
    EXPECT_THROW(stage.turns.wait(member, milliseconds(10)), std::runtime_error);
  });
  stage.add('b', milliseconds(20), 2);
  EXPECT_EQ(stage.run(), "bb");
  EXPECT_EQ(stage.clock.now(), milliseconds(40));
}

int is_value(const void* what, long value) { return *static_cast<const int*>(what) == value; }

TEST(ThreadTurns, DoNotParkAtWhatIsThereAlready) {
  Stage stage;
  const int what = 7;
  stage.add('a', milliseconds(10), 1);
  EXPECT_FALSE(stage.turns.park(*stage.me, &what, milliseconds(5), {is_value, 7, false}));
  EXPECT_EQ(stage.clock.now(), Time(0));
  EXPECT_TRUE(stage.turns.park(*stage.me, &what, milliseconds(5), {is_value, 8, false}));
  stage.run();
}

// As a signal's handler does.
TEST(ThreadTurns, SeeWhatOthersGiveAndLetTheFirstOneHaveIt) {
  Stage stage;
  int what = 0;
  for (const char name : {'a', 'b'}) {
    const Time later = milliseconds(name == 'a' ? 2 : 1);  // b waits first
    stage.add([&stage, &what, name, later](Member& member) {
      stage.turns.wait(member, later);
      EXPECT_FALSE(stage.turns.park(member, &what, ThreadTurns::kNever, {is_value, 1, true}));
      stage.text += name;
      what = name == 'a' ? 0 : 1;  // b leaves it for a
    });
  }
  stage.turns.wait(*stage.me, milliseconds(10));
  what = 1;
  EXPECT_EQ(stage.run(), "ba");
}

// As a timer's function does.
TEST(ThreadTurns, GoOnFromEventToEventWhereAllWaitForEver) {
  PlainClock clock;
  int what = 0;
  ThreadTurns::Events events;
  events.next = [&]() -> std::optional<Time> {
    return what < 3 ? std::optional(Time(milliseconds(10 * (what + 1)))) : std::nullopt;
  };
  events.run = [&] { ++what; };
  ThreadTurns turns([](Member&) { return ThreadState{}; }, [] {}, events);
  Member& me = turns.adopt(1);
  turns.begin(clock);
  EXPECT_FALSE(turns.park(me, &what, ThreadTurns::kNever, {is_value, 3, false}));
  EXPECT_EQ(clock.now(), milliseconds(30));
  // Where somebody waits for a moment, he lets them happen himself.
  what = 0;
  EXPECT_TRUE(turns.park(me, &what, milliseconds(35), {is_value, 3, false}));
  EXPECT_EQ(what, 0);
}

TEST(ThreadTurns, AreStuckWhereNobodyCanWakeOne) {
  const auto is_stuck = [](const ThreadTurns::Unless& unless) {
    Stage stage;
    const int what = 0;
    stage.add([&](Member& member) {
      stage.turns.park(member, &what, ThreadTurns::kNever, unless);
      EXPECT_FALSE(stage.turns.are_stuck());  // woken
    });
    stage.turns.wait(*stage.me, milliseconds(5));
    EXPECT_FALSE(stage.turns.are_stuck());  // one goes on
    std::thread looks([&] {
      while (stage.me->stage != Member::Stage::Waiting) std::this_thread::yield();
      stage.text = stage.turns.are_stuck() ? "stuck" : "waiting";
      stage.turns.end();
    });
    stage.turns.park(*stage.me, &stage, ThreadTurns::kNever);
    looks.join();
    const std::string seen = stage.text;
    stage.run();
    return seen == "stuck";
  };
  const auto no = [](const void*, long) { return 0; };
  EXPECT_TRUE(is_stuck({}));
  EXPECT_TRUE(is_stuck({no, 0, true}));
  EXPECT_FALSE(is_stuck({no, 0, true, true}));
}

TEST(ThreadTurns, LetEverybodyGoAtTheEnd) {
  Stage stage;
  const int what = 0;
  stage.add([&](Member& member) {
    EXPECT_FALSE(stage.turns.park(member, &what, ThreadTurns::kNever));
    EXPECT_FALSE(stage.turns.park(member, &what, ThreadTurns::kNever));  // never again
  });
  stage.turns.wait(*stage.me, milliseconds(5));
  stage.turns.end();
  stage.add([](Member&) {});
  stage.run();
}

TEST(ThreadTurns, AdoptAThreadOnce) {
  Stage stage;
  EXPECT_EQ(&stage.turns.adopt(7), &stage.turns.adopt(7));
  EXPECT_FALSE(stage.turns.is_alone());
}

TEST(ThreadTurns, AskNobodyForOneThread) {
  Stage stage;
  stage.look = [](Member&) -> ThreadState {
    ADD_FAILURE();
    return {};
  };
  stage.turns.wait(*stage.me, milliseconds(10));
  EXPECT_TRUE(stage.turns.park(*stage.me, nullptr, milliseconds(20)));
  EXPECT_EQ(stage.clock.now(), milliseconds(20));
}

TEST(ThreadTurns, AreNotTakenBeforeTheyBegin) {
  ThreadTurns turns([](Member&) { return ThreadState{}; }, [] {});
  Member& me = turns.adopt(1);
  Member& other = turns.expect();
  turns.start(other);
  turns.leave(other);
  EXPECT_FALSE(turns.have_begun());
  turns.leave(me);
}

}  // namespace
}  // namespace eyebridge::robios
