#pragma once

#include <algorithm>
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/bridges/client/can_client.hpp"
#include "eyebridge/bridges/memory.hpp"
#include "fake_robot.hpp"
#include "kept_log.hpp"

namespace eyebridge::bridges::testing {

using namespace std::chrono_literals;

/// Virtual time that moves only when somebody waits, and a world that lives meanwhile.
class LivingClock final : public Clock {
 public:
  [[nodiscard]] Time now() const override { return now_; }
  void wait_until(Time deadline) override {
    while (now_ < deadline) {
      now_ = std::min<Time>(deadline, now_ + 5ms);
      if (live) live();
    }
  }
  void spend(Time cost) override { wait_until(now_ + cost); }
  [[nodiscard]] bool is_virtual() const override { return true; }

  std::function<void()> live;  ///< Must not wait itself.

 private:
  Time now_{0};
};

/// A client and the robot with its number on a bus in memory, on virtual time.
class CanBench : public ::testing::Test {
 protected:
  /// Both sides live for `span`.
  void live(Time span) {
    for (const Time end = clock.now() + span; clock.now() < end;) client->pump(clock.now() + 10ms);
  }
  CanBench() {
    clock.live = [this] { robot.step(); };
  }
  void become_ready() {
    live(1s);
    ASSERT_EQ(client->phase(), RobotWatch::Phase::Ready) << log.text();
  }

  LivingClock clock;
  KeptLog log;
  MemoryCan bus{clock};
  FakeRobot robot{bus.connect("robot"), 1, clock};
  std::unique_ptr<CanClient> client =
      std::make_unique<CanClient>(bus.connect("can0"), 1, clock, log);
};

}  // namespace eyebridge::bridges::testing
