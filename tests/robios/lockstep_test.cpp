#include "lockstep.hpp"

#include <chrono>
#include <string>

#include <gtest/gtest.h>

namespace eyebridge::robios {
namespace {

using std::chrono::milliseconds;
constexpr Time kStep = milliseconds(10);

/// Robots that write into one text when they have their turns; a step of the world is a "|".
struct Players {
  Lockstep lockstep;
  std::string text;

  /// A robot that writes `name`, waits so long, and so on: `turns` times.
  void add(char name, Time pause, int turns, Time start = Time(0)) {
    const std::size_t robot = robots++;
    lockstep.add(
        [this, robot, name, pause, turns, start] {
          Time now = start;
          for (int i = 0; i < turns; ++i) {
            text += name;
            now += pause;
            if (now >= lockstep.limit_of(robot)) lockstep.wait(robot, now);
          }
          lockstep.drop_robot();
        },
        start);
  }
  /// One that comes after so long to where all meet, as a small letter, and has two turns then.
  void gather(char name, Time before) {
    ++robots;
    lockstep.add(
        [this, name, before] {
          if (before > Time(0)) lockstep.park(before);
          text += name;
          lockstep.count_in(before);
          const Time met = lockstep.meet();
          const auto capital = static_cast<char>(name - 'a' + 'A');
          text += capital;
          lockstep.park(met + kStep);
          text += capital;
          lockstep.drop_robot();
        },
        Time(0));
  }
  std::string run() {
    lockstep.run(kStep, [this] { text += '|'; });
    return text;
  }

  std::size_t robots = 0;
};

TEST(Lockstep, GivesTurnsInTheOrderOfNumbers) {
  Players players;
  players.add('a', kStep, 3);
  players.add('b', kStep, 3);
  players.add('c', kStep, 3);
  EXPECT_EQ(players.run(), "abc|abc|abc|");
}

TEST(Lockstep, LetsSleepersSleep) {
  Players players;
  players.add('a', 2 * kStep, 2);
  players.add('b', kStep, 4);
  players.add('c', 3 * kStep, 2);
  players.add('d', kStep, 4);
  EXPECT_EQ(players.run(), "abcd|bd|abd|bcd|||");
}

TEST(Lockstep, GivesSeveralTurnsInOneRound) {
  Players players;
  players.add('a', milliseconds(4), 4);
  players.add('b', kStep, 2);
  EXPECT_EQ(players.run(), "aaab|ab|");
}

TEST(Lockstep, BeginsARobotAtItsTime) {
  Players players;
  players.add('a', kStep, 3);
  players.add('b', kStep, 2, 2 * kStep);
  players.add('c', kStep, 2);
  EXPECT_EQ(players.run(), "ac|ac|ab|b|");
}

TEST(Lockstep, CountsSwitches) {
  Players players;
  players.add('a', kStep, 2);
  players.add('b', kStep, 2);
  players.run();
  EXPECT_EQ(players.lockstep.switches(), 6U);  // the last ones are those in which they end
}

TEST(Lockstep, GoesOnWithoutWhoWasDroppedBetweenRounds) {
  Players players;
  for (const char name : {'a', 'b', 'c'}) players.add(name, kStep, 4);
  int steps = 0;
  players.lockstep.run(kStep, [&] {
    players.text += '|';
    if (++steps == 2) players.lockstep.drop(1);
  });
  EXPECT_EQ(players.text, "abc|abc|ac|ac|");
}

TEST(Lockstep, WaitsForWhoIsExpected) {
  Players players;
  players.add('a', kStep, 1);
  players.lockstep.expect(1);
  int steps = 0;
  players.lockstep.run(kStep, [&] {
    players.text += '|';
    if (++steps != 3) return;
    players.lockstep.expect(0);
    players.add('b', kStep, 2, 3 * kStep);
  });
  EXPECT_EQ(players.text, "a|||b|b|");
}

TEST(Lockstep, LetsAllGoInOrderOnceTheLastOneHasCome) {
  Players players;
  players.lockstep.gather(3);
  players.gather('a', Time(0));
  players.gather('b', milliseconds(15));
  players.gather('c', milliseconds(3));
  EXPECT_EQ(players.run(), "ac|bABC|ABC");
}

TEST(Lockstep, WaitsForNobodyWhoHasEnded) {
  Players players;
  players.lockstep.gather(3);
  players.gather('a', Time(0));
  players.robots++;
  players.lockstep.add(
      [&] {
        players.lockstep.park(milliseconds(15));
        players.lockstep.count_in(milliseconds(15));
        players.lockstep.drop_robot();
      },
      Time(0));
  EXPECT_EQ(players.run(), "a|A|A");
}

}  // namespace
}  // namespace eyebridge::robios
