// A robot that a person carries, in virtual time.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hand/hand_drive.hpp"
#include "hand_rig.hpp"

namespace eyebridge::hal {
namespace {

using testing::HasSubstr;
using Kind = Instruction::Kind;

TEST(Hand, AllSensorsSeeWhatIsRoundTheCamera) {
  const HandRig rig;
  for (const Pose& pose : {Pose{1.0, 1.0, 0.0}, Pose{2.2, 0.6, 0.0}, Pose{0.5, 1.4, kPi / 2}}) {
    rig.put(pose);
    rig.wait(0.1);
    const bool to_the_east = pose.theta == 0.0;
    const double front = to_the_east ? 3.0 - pose.x : 2.0 - pose.y;
    EXPECT_NEAR(rig.robot->range_sensor(1)->read().value(), front - kFrontOffset, 1e-9);
    std::vector<double> ahead(1);
    ASSERT_TRUE(rig.robot->lidar()->configure(1.0, 0.0, 1));
    ASSERT_TRUE(rig.robot->lidar()->read(ahead));
    EXPECT_NEAR(ahead[0], front, 1e-9);
    EXPECT_NEAR(rig.robot->compass()->read().value(), pose.theta, 1e-9);
    EXPECT_NEAR(rig.robot->world()->robot_pose(0).value().x, pose.x, 1e-9);
    const camera::Eye eye = rig.robot->camera_view()->eye();
    EXPECT_NEAR(norm(Vec2{eye.x, eye.y} - pose.position()), robot::CameraModel{}.x, 1e-9);
  }
}

TEST(Hand, NobodyKnowsHowAPersonTurnsAndHurries) {
  const HandRig rig;
  EXPECT_EQ(rig.robot->gyroscope(), nullptr);
  EXPECT_EQ(rig.robot->accelerometer(), nullptr);
}

TEST(Hand, ABumperFeelsTheWallThatTheCameraIsHeldAgainst) {
  const HandRig rig;
  const double radius = robot::RobotModel{}.radius();
  EXPECT_FALSE(rig.robot->bumper(1)->read().value());
  rig.put({3.0 - radius - 0.001, 1.0, 0.0});
  rig.wait(0.1);
  EXPECT_TRUE(rig.robot->bumper(1)->read().value());
  EXPECT_TRUE(rig.robot->proximity(1)->read().value());
}

TEST(Hand, APoseInAWallIsTakenAsItIs) {
  const HandRig rig;
  for (const Pose& pose :
       {Pose{3.0, 1.0, 0.0}, Pose{3.0001, 1.0, 1.0}, Pose{0.0, 0.0, 2.0}, Pose{-1.0, 50.0, 3.0}}) {
    rig.put(pose);
    rig.wait(0.1);
    EXPECT_NEAR(rig.robot->world()->robot_pose(0).value().x, pose.x, 1e-9);
    EXPECT_TRUE(rig.robot->bumper(1)->read());
    for (int id = 1; id <= 4; ++id) EXPECT_GE(rig.robot->range_sensor(id)->read().value(), 0.0);
  }
  rig.put({1.0, 1.0, 0.0});
  rig.wait(0.1);
  EXPECT_NEAR(rig.robot->range_sensor(1)->read().value(), 2.0 - kFrontOffset, 1e-9);
}

TEST(Hand, OdometryBeginsWhereTheCameraWasSeenFirstAndIsWhatWasSetLast) {
  const HandRig rig;
  rig.put({1.0, 1.0, kPi / 2});
  rig.wait(0.1);
  EXPECT_EQ(rig.robot->drive()->odometry().value(), Pose{});
  rig.put({1.0, 1.3, kPi / 2});
  rig.wait(0.1);
  Pose odometry = rig.robot->drive()->odometry().value();
  EXPECT_NEAR(odometry.x, 0.3, 1e-9);
  EXPECT_NEAR(odometry.y, 0.0, 1e-9);
  ASSERT_TRUE(rig.robot->drive()->set_odometry({5.0, 6.0, 0.0}));
  rig.put({1.0, 1.3, kPi});
  rig.wait(0.1);
  odometry = rig.robot->drive()->odometry().value();
  EXPECT_NEAR(odometry.x, 5.0, 1e-9);
  EXPECT_NEAR(odometry.y, 6.0, 1e-9);
  EXPECT_NEAR(odometry.theta, kPi / 2, 1e-9);
}

TEST(Hand, ThePersonIsToldWhatTheProgramWantsAndTheMovementEndsWhenItIsMade) {
  const HandRig rig;
  rig.wait(0.1);
  ASSERT_TRUE(rig.robot->drive()->start({0.3, 0.0, 0.1}));
  EXPECT_EQ(in_words(rig.told()), "forward 0.30 m at 0.10 m/s");
  const Time begin = rig.robot->clock().now();
  EXPECT_EQ(rig.wait_for_drive().value().progress, DriveProgress::Done);
  EXPECT_EQ(rig.told().kind, Kind::Stand);
  EXPECT_NEAR(to_seconds(rig.robot->clock().now() - begin), 0.28 / rig.hand->linear, 0.1);
  EXPECT_NEAR(rig.place().x, facing(1.0).x + 0.3, 0.025);
  EXPECT_NEAR(rig.robot->drive()->odometry().value().x, 0.3, 0.025);
}

TEST(Hand, RemainingIsWhatIsStillToGoAndNothingStalls) {
  const HandRig rig;
  ASSERT_TRUE(rig.robot->drive()->start({1.0, 0.0, 0.1}));
  rig.wait(2.0);
  const DriveStatus status = rig.robot->drive()->status().value();
  EXPECT_EQ(status.progress, DriveProgress::Driving);
  EXPECT_NEAR(status.remaining, 1.0 - 2.0 * rig.hand->linear, 0.01);
  EXPECT_FALSE(status.stalled_left || status.stalled_right);
}

TEST(Hand, SpeedIsThatOfTheHand) {
  const HandRig rig;
  ASSERT_TRUE(rig.robot->drive()->set_speed({0.15, 0.4}));
  rig.wait(1.0);
  const Twist twist = rig.robot->drive()->measured_twist().value();
  EXPECT_NEAR(twist.linear, 0.15, 0.002);
  EXPECT_NEAR(twist.angular, 0.4, 0.002);
  EXPECT_EQ(rig.robot->drive()->status().value().progress, DriveProgress::Done);
  ASSERT_TRUE(rig.robot->drive()->set_speed({}));
  rig.wait(1.0);
  EXPECT_NEAR(rig.robot->drive()->measured_twist().value().linear, 0.0, 1e-9);
}

TEST(Hand, BadNumbersAreRefusedAsByAnyDrive) {
  const HandRig rig;
  const double nan = std::nan("");
  EXPECT_EQ(rig.robot->drive()->set_speed({nan, 0.0}).error().code, Errc::OutOfRange);
  EXPECT_EQ(rig.robot->drive()->start({1.0, 0.0, -1.0}).error().code, Errc::OutOfRange);
  EXPECT_EQ(rig.robot->drive()->set_odometry({nan, 0.0, 0.0}).error().code, Errc::OutOfRange);
}

TEST(Hand, ThereAreNoMotors) {
  const HandRig rig;
  EXPECT_EQ(rig.robot->motor(1), nullptr);
  EXPECT_EQ(rig.robot->encoder(1), nullptr);
}

TEST(Hand, CallsWaitForARobotThatIsLostAndGoOnWhenItIsSeen) {
  const HandRig rig;
  rig.wait(0.1);
  ASSERT_TRUE(rig.robot->drive()->start({0.3, 0.0, 0.1}));
  rig.wait(0.5);
  rig.hand->is_lost = true;
  rig.wait(0.2);
  EXPECT_EQ(rig.told().kind, Kind::Lost);
  EXPECT_THAT(in_words(rig.told()), HasSubstr("show me a marker"));
  rig.hand->is_lost = false;
  const Time before = rig.robot->clock().now();
  EXPECT_EQ(rig.robot->drive()->status().value().progress, DriveProgress::Driving);
  EXPECT_LE(rig.robot->clock().now() - before, std::chrono::milliseconds(60));
  EXPECT_EQ(rig.wait_for_drive().value().progress, DriveProgress::Done);
}

TEST(Hand, ALostRobotIsAnErrorAfterTenSecondsNeverAnOldReading) {
  const HandRig rig;
  rig.wait(1.0);
  rig.hand->is_lost = true;
  rig.wait(0.1);
  const auto reading = rig.robot->range_sensor(1)->read();
  ASSERT_FALSE(reading);
  EXPECT_EQ(reading.error().code, Errc::Timeout);
  EXPECT_EQ(reading.error().what, "the camera has seen no marker since 1.0 s on its clock");
  EXPECT_NEAR(to_seconds(rig.robot->clock().now()), 11.0, 0.05);
  const Time then = rig.robot->clock().now();
  std::vector<double> scan(8);
  EXPECT_FALSE(rig.robot->lidar()->read(scan));
  EXPECT_FALSE(rig.robot->drive()->odometry());
  EXPECT_FALSE(rig.robot->drive()->status());
  EXPECT_FALSE(rig.robot->drive()->measured_twist());
  EXPECT_FALSE(rig.robot->drive()->start({1.0, 0.0, 1.0}));
  EXPECT_TRUE(rig.robot->drive()->set_speed({})) << "stopping needs no place";
  EXPECT_EQ(rig.robot->clock().now(), then) << "and once it has failed nothing waits any more";
}

TEST(Hand, ACameraThatIsGoneSaysSo) {
  const HandRig rig;
  rig.wait(1.0);
  *rig.trouble = Error{Errc::Disconnected, "camera: unplugged"};
  EXPECT_TRUE(rig.robot->range_sensor(1)->read()) << "one frame's time is no loss";
  rig.wait(1.0);
  EXPECT_EQ(in_words(rig.told()), "lost: show me a marker (camera: unplugged)");
  const auto reading = rig.robot->range_sensor(1)->read();
  ASSERT_FALSE(reading);
  EXPECT_EQ(reading.error().code, Errc::Disconnected);
  EXPECT_EQ(reading.error().what, "camera: unplugged");
  rig.trouble->reset();
  rig.wait(0.1);
  EXPECT_TRUE(rig.robot->range_sensor(1)->read());
}

TEST(Hand, ARobotThatWasNeverSeenIsWaitedFor) {
  const HandRig rig;
  rig.hand->is_lost = true;
  EXPECT_FALSE(rig.robot->range_sensor(1)->read());
  EXPECT_EQ(rig.robot->clock().now(), kHandPatience);
  rig.hand->is_lost = false;
  rig.wait(0.1);
  EXPECT_TRUE(rig.robot->range_sensor(1)->read());
}

TEST(Hand, TheProgramsFramesAreThoseOfThePersonsCamera) {
  const HandRig rig;
  camera::Source* source = rig.robot->camera_source();
  ASSERT_NE(source, nullptr);
  ASSERT_TRUE(source->set_size(32, 24));
  rig.wait(1.0);
  const camera::FramePtr frame = source->next(rig.robot->clock().now()).value();
  EXPECT_EQ(frame->width, 32);
  EXPECT_EQ(rig.hand->width, 64) << "the finder gets the camera's own size";
  EXPECT_EQ(rig.hand->frames, 31) << "and every frame";
  EXPECT_NEAR(to_seconds(frame->time), 1.0, 1e-6);
}

TEST(Hand, AfterTheEndThePersonStandsStill) {
  const HandRig rig;
  rig.wait(0.1);
  ASSERT_TRUE(rig.robot->drive()->set_speed({0.2, 0.0}));
  EXPECT_EQ(rig.told().kind, Kind::Speed);
  rig.robot->stop();
  EXPECT_EQ(rig.told().kind, Kind::Stand);
}

/// What examples/square does.
Pose drive_squares(const HandRig& rig, int sides) {
  for (int side = 0; side < sides; ++side) {
    EXPECT_TRUE(rig.robot->drive()->start({0.4, 0.0, 0.2}));
    EXPECT_EQ(rig.wait_for_drive().value().progress, DriveProgress::Done);
    EXPECT_TRUE(rig.robot->drive()->start({0.0, deg_to_rad(90), deg_to_rad(90)}));
    EXPECT_EQ(rig.wait_for_drive().value().progress, DriveProgress::Done);
  }
  return rig.place();
}

TEST(Hand, APersonWhoObeysDrivesTheProgramsSquares) {
  const HandRig rig;
  rig.hand->noise = 0.004;  // metres, and radians
  rig.put({1.5, 0.6, 0.0});
  const Pose end = drive_squares(rig, 8);
  EXPECT_NEAR(end.x, 1.5, 0.04);
  EXPECT_NEAR(end.y, 0.6, 0.04);
  EXPECT_NEAR(end.theta, 0.0, deg_to_rad(5));
}

TEST(Hand, TheSameRunIsTheSameEveryTime) {
  const auto run = [] {
    const HandRig rig;
    rig.hand->noise = 0.004;
    drive_squares(rig, 2);
    const Pose end = rig.place();
    return std::tuple{end.x, end.y, end.theta, rig.robot->clock().now(), rig.hand->frames};
  };
  EXPECT_EQ(run(), run());
}

TEST(Hand, ACurveIsWalkedToItsEnd) {
  const HandRig rig;
  rig.put({1.0, 0.5, 0.0});
  ASSERT_TRUE(rig.robot->drive()->start({0.5 * kPi * 0.5, kPi / 2, 0.2}));
  EXPECT_EQ(rig.wait_for_drive().value().progress, DriveProgress::Done);
  EXPECT_NEAR(rig.place().x, 1.5, 0.03);
  EXPECT_NEAR(rig.place().y, 1.0, 0.03);
  EXPECT_NEAR(rig.place().theta, kPi / 2, deg_to_rad(3.5));
}

}  // namespace
}  // namespace eyebridge::hal
