// v-omega on the host, over a board that has only motors and encoders.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "board_peer.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::hal::testing {
namespace {

class BoardHost : public ::testing::Test, protected BoardPeer {
 protected:
  void SetUp() override {
    backend = make_backend(default_board_tables());
    ASSERT_NE(backend, nullptr);
    ASSERT_NE(backend->drive(), nullptr);
    turn(100ms);
  }
  /// `span` passes, and the wheels turn as they were told last.
  void turn(Time span) {
    for (const Time end = clock.now() + span; clock.now() < end;) {
      const Time start = clock.now();
      backend->step();
      clock.wait_until(start + 10ms);
      for (const int id : {1, 2}) encoder[id] += motor[id];
    }
  }
  DriveStatus finish() {
    for (int i = 0; i < 1000; ++i) {
      turn(10ms);
      const auto status = backend->drive()->status();
      if (!status || status->progress != DriveProgress::Driving) break;
    }
    turn(200ms);
    return backend->drive()->status().value();
  }

  std::unique_ptr<BoardBackend> backend;
};

TEST_F(BoardHost, DrivesAsFarAsItIsTold) {
  ASSERT_TRUE(backend->drive()->start({0.3, 0.0, 0.3}));
  EXPECT_EQ(finish().progress, DriveProgress::Done);
  EXPECT_NEAR(backend->drive()->odometry().value().x, 0.3, 2e-3);
  EXPECT_NEAR(backend->encoder(1)->read().value(), 0.3 * 6484, 15);
  EXPECT_EQ(motor[1], 0);
  EXPECT_EQ(motor[2], 0);
}

TEST_F(BoardHost, TurnsAsFarAsItIsTold) {
  ASSERT_TRUE(backend->drive()->start({0.0, kPi / 2, 1.0}));
  EXPECT_EQ(finish().progress, DriveProgress::Done);
  EXPECT_NEAR(backend->drive()->odometry().value().theta, kPi / 2, 0.02);
}

TEST_F(BoardHost, ACountThatComesLateIsNoTurn) {
  rolls = true;
  rolled = clock.now();
  ASSERT_TRUE(backend->drive()->start({0.4 * kPi / 2, kPi / 2, 0.3}));
  double turned_back = 0.0;
  double theta = 0.0;
  for (int i = 0; i < 400; ++i) {
    if (i == 60) stall = 9ms;  // less than a client waits
    live(*backend, 10ms);
    const double now = backend->drive()->odometry().value().theta;
    turned_back = std::max(turned_back, theta - now);
    theta = now;
  }
  EXPECT_EQ(backend->drive()->status().value().progress, DriveProgress::Done);
  EXPECT_NEAR(theta, kPi / 2, 0.01);
  EXPECT_LT(turned_back, 0.005);
}

TEST_F(BoardHost, AMotorThatIsUsedAloneIsNotDrivenAnyMore) {
  ASSERT_TRUE(backend->drive()->set_speed({0.3, 0.0}));
  turn(500ms);
  EXPECT_GT(motor[1], 0);
  ASSERT_TRUE(backend->motor(1)->set_duty(0.0));
  ASSERT_TRUE(backend->motor(2)->set_duty(0.0));
  told.clear();
  turn(200ms);
  EXPECT_EQ(told.find('M'), std::string::npos) << told;
}

TEST_F(BoardHost, StopEndsTheDriveToo) {
  ASSERT_TRUE(backend->drive()->set_speed({0.3, 0.0}));
  turn(500ms);
  backend->stop();
  turn(200ms);
  EXPECT_EQ(motor[1], 0);
  EXPECT_EQ(motor[2], 0);
}

TEST_F(BoardHost, ALostReplyOrTwoAreTheLinesTroubleNotTheDrives) {
  ASSERT_TRUE(backend->drive()->start({0.5, 0.0, 0.3}));
  turn(500ms);
  mute = 2;  // the repetition is lost, too
  backend->step();
  EXPECT_EQ(mute, 0);
  EXPECT_EQ(backend->drive()->status().value().progress, DriveProgress::Driving);
  ASSERT_TRUE(backend->drive()->start({0.2, 0.0, 0.3}));
  EXPECT_EQ(finish().progress, DriveProgress::Done);
}

TEST_F(BoardHost, EncodersThatAreNotToldAnyMoreAreAnErrorNotAnOldReading) {
  ASSERT_TRUE(backend->drive()->start({2.0, 0.0, 0.3}));
  turn(500ms);
  mute = 1000;
  turn(500ms);
  EXPECT_EQ(backend->drive()->odometry().error().code, Errc::Timeout);
  EXPECT_EQ(backend->drive()->status().error().code, Errc::Timeout);
  mute = 0;
  turn(100ms);
  EXPECT_TRUE(backend->drive()->odometry());
}

TEST_F(BoardHost, ADriveThatIsBlindForHalfASecondStands) {
  ASSERT_TRUE(backend->drive()->start({2.0, 0.0, 0.3}));
  turn(500ms);
  ASSERT_GT(motor[1], 0);
  mute = 1000;
  turn(200ms);
  EXPECT_GT(motor[1], 0) << "a line that loses some bytes is no reason yet";
  turn(500ms);
  EXPECT_EQ(motor[1], 0);
  EXPECT_EQ(motor[2], 0);
  mute = 0;
  turn(500ms);
  EXPECT_EQ(motor[1], 0) << "what the program was not told of goes on";
  EXPECT_EQ(backend->drive()->status().value().progress, DriveProgress::Failed);
  ASSERT_TRUE(backend->drive()->set_speed({0.1, 0.0}));
  turn(500ms);
  EXPECT_GT(motor[1], 0);
}

TEST_F(BoardHost, AStopIsTakenThoughTheEncodersAreSilent) {
  ASSERT_TRUE(backend->drive()->set_speed({0.3, 0.0}));
  turn(500ms);
  ASSERT_GT(motor[1], 0);
  mute = 1000;
  turn(50ms);
  EXPECT_TRUE(backend->drive()->set_speed({0.0, 0.0}));
  turn(250ms);  // two questions that were not answered
  EXPECT_EQ(motor[1], 0) << "long before the drive gives up";
  EXPECT_EQ(motor[2], 0);
  turn(500ms);
  EXPECT_EQ(backend->drive()->set_speed({0.2, 0.0}).error().code, Errc::Timeout);
  EXPECT_EQ(backend->drive()->set_speed({0.0, 0.0}).error().code, Errc::Timeout) << "it is said";
  mute = 0;
  turn(500ms);
  EXPECT_EQ(motor[1], 0) << "a command that was refused is obeyed";
}

TEST_F(BoardHost, AStopThatWasRefusedIsObeyedOnceTheBoardIsHeardAgain) {
  ASSERT_TRUE(backend->drive()->set_speed({0.3, 0.0}));
  turn(500ms);
  // Nobody reads the encoders for so long: another question is not answered.
  clock.wait_until(clock.now() + 600ms);
  EXPECT_EQ(backend->drive()->set_speed({0.0, 0.0}).error().code, Errc::Timeout);
  turn(500ms);
  EXPECT_EQ(motor[1], 0);
  EXPECT_EQ(motor[2], 0);
}

TEST_F(BoardHost, ABoardThatWasUnpluggedStandsWhenItIsBackAndItsGoalHasFailed) {
  ASSERT_TRUE(backend->drive()->start({2.0, 0.0, 0.3}));
  turn(500ms);
  line->gone = true;
  turn(100ms);
  EXPECT_EQ(backend->drive()->status().error().code, Errc::Disconnected);
  EXPECT_EQ(backend->drive()->set_speed({0.1, 0.0}).error().code, Errc::Disconnected);
  motor = {};
  encoder = {};
  plug_in();
  turn(3s);
  EXPECT_EQ(backend->drive()->status().value().progress, DriveProgress::Failed);
  EXPECT_EQ(motor[1], 0);
  ASSERT_TRUE(backend->drive()->set_speed({0.1, 0.0}));
  turn(500ms);
  EXPECT_GT(motor[1], 0);
}

}  // namespace
}  // namespace eyebridge::hal::testing
