#include "probe/can_census.hpp"

#include <memory>
#include <vector>

#include <gmock/gmock.h>

#include "../bridges/client/can_bench.hpp"

namespace eyebridge::apps {
namespace {

using namespace std::chrono_literals;
using bridges::CanBus;
using bridges::CanFrame;
using bridges::MemoryCan;
using bridges::testing::FakeRobot;
using bridges::testing::LivingClock;
using bridges::testing::raw_frame;
using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// A bus in memory with robots on it, on virtual time, and one who only watches what is sent.
class Census : public ::testing::Test {
 protected:
  Census() {
    clock.live = [this] {
      for (const auto& robot : robots) robot->step();
    };
  }
  FakeRobot& add_robot(int node) {
    robots.push_back(std::make_unique<FakeRobot>(bus.connect("robot"), node, clock));
    return *robots.back();
  }
  CanCensus listen(Time span = 1500ms) {
    const auto census = listen_to(*ours, clock, span);
    EXPECT_TRUE(census) << census.error().what;
    return census.value_or(CanCensus{});
  }

  LivingClock clock;
  MemoryCan bus{clock, 4096};
  std::unique_ptr<CanBus> ours = bus.connect("can0");
  std::vector<std::unique_ptr<FakeRobot>> robots;
};

TEST_F(Census, ASilentBusHasNoRobots) {
  const auto other = bus.connect("nobody");
  const CanCensus census = listen();
  EXPECT_THAT(census.robots, IsEmpty());
  EXPECT_THAT(described(census, "can0"), HasSubstr("0 robots heard; 0 frames"));
}

TEST_F(Census, EachRobotIsShownWithWhatItTells) {
  add_robot(1).state = 0x7F;
  add_robot(3).state = 5;
  const CanCensus census = listen();
  ASSERT_EQ(census.robots.size(), 2u);
  const HeardRobot& first = census.robots.at(1);
  EXPECT_EQ(first.state, EYECAN_STATE_STANDBY);
  EXPECT_THAT(first.psds, ElementsAre(1, 2)) << "0xFFFF is none, 9999 is one that sees nothing";
  EXPECT_TRUE(first.drives);
  EXPECT_TRUE(first.has_encoders);
  EXPECT_FALSE(first.twice);
  ASSERT_TRUE(first.board);
  EXPECT_EQ(first.board->battery_cv, 740);
  EXPECT_FALSE(census.has_host);
  const std::string text = described(census, "can0");
  EXPECT_THAT(text, AllOf(HasSubstr("2 robots heard"), HasSubstr("7.40 V"), HasSubstr("PSD 1 2\n"),
                          ContainsRegex("robot 1\n +state +standby"),
                          ContainsRegex("robot 3\n +state +operational"),
                          HasSubstr("eyebridge run --hal 'can:can0?node=3' PROGRAM")));
}

TEST_F(Census, NothingIsSentButAQuestionForTheVersion) {
  FakeRobot& robot = add_robot(2);
  listen();
  ASSERT_EQ(robot.heard.size(), 1u);
  EXPECT_TRUE(robot.heard[0].remote);
  EXPECT_EQ(robot.heard[0].id, 0x482u);
}

TEST_F(Census, ARobotThatToldItsVersionIsNotAsked) {
  FakeRobot& robot = add_robot(2);
  robot.send(0x48, {1, '1', '.', '0', '4', 2, 3, 1});
  const CanCensus census = listen();
  EXPECT_THAT(robot.heard, IsEmpty());
  EXPECT_THAT(described(census, "can0"), HasSubstr("1.04, protocol 1\n"));
}

TEST_F(Census, AnotherProtocolVersionIsPointedOut) {
  add_robot(2).send(0x48, {9, '9', '.', '9', '9', 2, 3, 1});
  EXPECT_THAT(described(listen(), "can0"), HasSubstr("protocol 9 (expected 1"));
}

TEST_F(Census, TwoRobotsWithOneNumberAreSaidAlsoWhenTheyStartedTogether) {
  add_robot(4);
  add_robot(4);
  const CanCensus census = listen();
  ASSERT_EQ(census.robots.size(), 1u);
  EXPECT_TRUE(census.robots.at(4).twice);
  EXPECT_THAT(described(census, "can0"),
              AllOf(HasSubstr("two robots have this number"), Not(HasSubstr("eyebridge run"))));
}

TEST_F(Census, TwoRobotsWithOneNumberAreSaidWhenOneIsOlder) {
  add_robot(4).started = -90s;
  add_robot(4);
  EXPECT_TRUE(listen().robots.at(4).twice);
}

TEST_F(Census, OneRobotThatRestartsIsNotTwo) {
  FakeRobot& robot = add_robot(4);
  bool restarted = false;
  clock.live = [&] {
    if (clock.now() > 700ms && !restarted) {
      robot.reboot();
      restarted = true;
    }
    robot.step();
  };
  EXPECT_FALSE(listen().robots.at(4).twice);
  EXPECT_TRUE(restarted);
}

TEST_F(Census, AnotherHostAndItsCommandsAreNoticed) {
  FakeRobot& robot = add_robot(1);
  robot.send(0x20, {100, 0, 0, 0, 1, 0});  // a command to this robot
  const CanCensus census = listen();
  EXPECT_TRUE(census.has_host);
  EXPECT_THAT(described(census, "can0"), HasSubstr("another program commands robots"));
  ASSERT_EQ(census.robots.size(), 1u);
}

TEST_F(Census, ForeignAndDamagedFramesAreCountedAndAreNoRobots) {
  const auto other = bus.connect("stranger");
  ASSERT_TRUE(other->send(raw_frame(0x7DF, {1, 2, 3}), 1s));
  ASSERT_TRUE(other->send(raw_frame(0x181, {1, 2}), 1s));
  const CanCensus census = listen();
  EXPECT_EQ(census.foreign, 1u);
  EXPECT_EQ(census.corrupt, 1u);
  EXPECT_THAT(census.robots, IsEmpty());
}

TEST_F(Census, FaultsAreToldInWords) {
  add_robot(1).send(0x08, {0x20, 0x31, 4, 0, 0, 0, 0, 0});
  EXPECT_THAT(described(listen(), "can0"), HasSubstr("the battery is low"));
}

TEST_F(Census, ALidarThatSendsFdFramesIsRunWithFd) {
  FakeRobot& robot = add_robot(1);
  robot.send(0x2C, {1, 0x68, 1, 0x68, 1, 0, 0, 0});
  CanFrame chunk{.id = 0x2D1, .length = 64};
  chunk.fd = true;
  chunk.data[1] = 30;
  ASSERT_TRUE(robot.bus->send(chunk, 1s));
  const CanCensus census = listen();
  EXPECT_EQ(census.robots.at(1).lidar_points, 360);
  EXPECT_THAT(described(census, "can0"), AllOf(HasSubstr("LIDAR of 360 points (in CAN FD frames)"),
                                               HasSubstr("'can:can0?node=1&fd=1'")));
}

TEST_F(Census, TheControllersErrorsAreTold) {
  add_robot(1);
  CanFrame report{.id = 0x4, .length = 8};  // CAN_ERR_CRTL, transmitter passive
  report.error = true;
  report.data[1] = 0x20;
  bus.report(report);
  EXPECT_THAT(described(listen(), "can0"), HasSubstr("reports 1 errors"));
}

TEST_F(Census, ABusThatGoesOffIsALoss) {
  add_robot(1);
  CanFrame report{.id = 0x40, .length = 8};  // CAN_ERR_BUSOFF
  report.error = true;
  bus.report(report);
  const auto census = listen_to(*ours, clock, 1s);
  ASSERT_FALSE(census);
  EXPECT_EQ(census.error().code, Errc::Disconnected);
  EXPECT_THAT(census.error().what, HasSubstr("bus off"));
}

}  // namespace
}  // namespace eyebridge::apps
