// Others on the bus that send under the robot's identifiers, and robots that were only silent.
#include <random>

#include "can_bench.hpp"

namespace eyebridge::bridges::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Phase = RobotWatch::Phase;

class CanForeign : public CanBench {
 protected:
  void SetUp() override {
    clock.live = [this] { step(); };
    become_ready();
  }
  void step() {
    robot.step();
    while (other->receive(Time{0})) continue;  // a full queue would hold the bus up
  }
  /// Sends `bytes` every `period` for `span`, while `look` looks every 10 ms.
  void disturb(std::uint32_t id, Time period, Time span, const std::function<void()>& look) {
    std::mt19937 random(7);
    Time due = clock.now();
    clock.live = [&, due]() mutable {
      step();
      for (; due <= clock.now(); due += period) {
        CanFrame frame = raw_frame(id, {0, 0, 0, 0, 0, 0, 0, 0});
        for (std::size_t i = 0; i < frame.length; ++i) {
          frame.data[i] = static_cast<std::uint8_t>(random());
        }
        (void)other->send(frame, Time{0});
      }
    };
    for (const Time end = clock.now() + span; clock.now() < end;) {
      live(10ms);
      look();
    }
    clock.live = [this] { step(); };
  }
  std::unique_ptr<CanBus> other = bus.connect("other");
};

class CanForeignPose : public CanForeign, public ::testing::WithParamInterface<int> {};

TEST_P(CanForeignPose, OfAnotherSenderIsNotTaken) {
  robot.x_mm = 30;
  live(100ms);
  const auto period = std::chrono::milliseconds(GetParam());
  int right = 0;
  disturb(0x181, period, 10s, [&] {
    const auto pose = client->latest<can::PoseStatus>();
    if (!pose) return;
    ++right;
    ASSERT_EQ(pose->x_mm, 30);
    ASSERT_EQ(pose->y_mm, 0);
  });
  EXPECT_THAT(log.text(), HasSubstr("somebody else sends 181, too (S_Pose)"));
  if (period < 50ms) return;
  EXPECT_GT(right, 800) << "a second sender that is seldom there costs little";
  EXPECT_EQ(client->phase(), Phase::Ready);
}
INSTANTIATE_TEST_SUITE_P(Periods, CanForeignPose, ::testing::Values(2, 5, 13, 20, 100, 700));

TEST_F(CanForeign, OneThatSendsAllTheTimeIsNamedAndEndsTheDrive) {
  ASSERT_TRUE(client->drive(100, 0));
  disturb(0x191, 20ms, 1s, [] {});
  EXPECT_EQ(client->phase(), Phase::Twice);
  EXPECT_THAT(client->drive(100, 0).error().what, HasSubstr("somebody else sends 191"));
}

TEST_F(CanForeign, AMoveIsNotDoneBecauseAnotherSaysSo) {
  ASSERT_TRUE(client->move({.type = 1, .distance_mm = 500, .speed = 250}));
  live(100ms);
  disturb(0x191, 70ms, 10s, [&] {
    const auto progress = client->move_progress();
    ASSERT_TRUE(progress);
    ASSERT_EQ(*progress, MoveProgress::Running);
  });
}

TEST_F(CanForeign, SecondSendersOfOtherMessagesAreNamed) {
  for (const std::uint32_t id : {0x1C1U, 0x1E1U, 0x1B1U, 0x281U}) {
    disturb(id, 50ms, 1s, [] {});
    char text[8];
    std::snprintf(text, sizeof text, "%X", id);
    EXPECT_THAT(log.text(), HasSubstr("somebody else sends " + std::string(text)));
  }
}

TEST_F(CanForeign, AnotherHostIsNamedAndEndsTheDrive) {
  ASSERT_TRUE(client->drive(100, 0));
  (void)other->send(raw_frame(0x201, {100, 0, 0, 0, 1, 0}), Time{0});
  live(50ms);
  EXPECT_EQ(client->phase(), Phase::Ready) << "one may be left over from a program that has ended";
  (void)other->send(raw_frame(0x201, {100, 0, 0, 0, 2, 0}), Time{0});
  live(50ms);
  EXPECT_EQ(client->phase(), Phase::Twice);
  EXPECT_THAT(client->drive(100, 0).error().what,
              HasSubstr("another program commands it (C_VWSpeed)"));
}

// A program ended while its robot was silent. Its guard stops the robot as soon as it hears it
// again.
TEST_F(CanBench, TheGuardOfAProgramBeforeIsNoSecondProgram) {
  const std::unique_ptr<CanBus> guard = bus.connect("guard");
  clock.live = [&] {
    robot.step();
    while (guard->receive(Time{0})) continue;
  };
  for (std::uint8_t i = 0; i < 20; ++i) {
    (void)guard->send(raw_frame(0x231, {0xF, 0, 0, 0, 0, 0, 0, i}), Time{0});
    (void)guard->send(raw_frame(0x011, {3, i}), Time{0});
    live(50ms);
    ASSERT_NE(client->phase(), Phase::Twice) << log.text();
  }
  EXPECT_GT(robot.count(0x20), 0U) << "by this the guard knows that the robot has a program again";
  become_ready();
}

TEST_F(CanForeign, SettingThePoseManyTimesIsNoSecondSender) {
  for (int i = 0; i < 50; ++i) {
    EXPECT_TRUE(client->set_pose({.x_mm = i % 2 == 0 ? 500 : 10, .y_mm = 0, .phi_cdeg = 0}));
    live(std::chrono::milliseconds(10 * (i % 4)));
  }
  EXPECT_THAT(log.text(), Not(HasSubstr("somebody else")));
}

TEST_F(CanForeign, ARobotThatWasOnlySilentHasNotRestarted) {
  constexpr unsigned kGaps = 1000;
  for (unsigned i = 0; i < kGaps; ++i) {
    robot.silent = true;
    live(std::chrono::milliseconds(400 + 170 * (i % 7)));
    EXPECT_EQ(client->phase(), Phase::Lost);
    robot.silent = false;
    live(600ms);
    ASSERT_EQ(client->phase(), Phase::Ready) << log.text();
  }
  EXPECT_EQ(client->restarts(), 0U);
  EXPECT_EQ(client->generation(), kGaps);
}

TEST_F(CanForeign, ARobotThatRestartedWhileItWasNotHeardHas) {
  robot.started = clock.now() - 2s;
  live(500ms);
  const std::uint32_t before = client->restarts();
  robot.silent = true;
  live(3s);
  robot.reboot();
  robot.state = 0x7F;  // its boot was not heard, either
  live(4s);            // so its uptime is more than before
  robot.silent = false;
  live(600ms);
  EXPECT_EQ(client->phase(), Phase::Ready);
  EXPECT_EQ(client->restarts(), before + 1);
}

TEST_F(CanForeign, ARestartIsCountedOnceHoweverItIsTold) {
  const std::uint32_t before = client->restarts();
  robot.reboot();
  live(1s);
  EXPECT_EQ(client->phase(), Phase::Ready);
  EXPECT_EQ(client->restarts(), before + 1);
}

TEST_F(CanForeign, FramesThatAreReadLateAreNoRestart) {
  clock.wait_until(clock.now() + 250ms);  // the robot lives, nobody reads
  live(1s);
  clock.wait_until(clock.now() + 3s);
  live(1s);
  EXPECT_EQ(client->restarts(), 0U);
  EXPECT_THAT(log.text(), Not(HasSubstr("somebody else")));
}

}  // namespace
}  // namespace eyebridge::bridges::testing
