// What a window can tell the person who carries a robot.
#include "eyebridge/hal/hand_guide.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/camera/frame.hpp"
#include "hand/shown_drive.hpp"
#include "hand_rig.hpp"

namespace eyebridge::hal {
namespace {

using ::testing::HasSubstr;
using Kind = Instruction::Kind;

TEST(HandGuide, IsThereWhereAPersonCarriesTheRobotAndNotElsewhere) {
  const HandRig rig;
  EXPECT_NE(rig.robot->hand_guide(), nullptr);
  EXPECT_EQ(lockstep_rig(facing(1.0)).backend->hand_guide(), nullptr);
}

TEST(HandGuide, TellsInstructionPoseAndPictureWithItsMarkers) {
  const HandRig rig;
  const HandGuide& guide = *rig.robot->hand_guide();
  EXPECT_EQ(guide.look().frame, nullptr) << "no frame has come";
  EXPECT_FALSE(guide.look().pose);
  rig.hand->seen = {{17, {Vec2{1, 2}, Vec2{9, 2}, Vec2{9, 10}, Vec2{1, 10}}}};
  rig.put({1.2, 1.1, 0.5});
  rig.wait(0.1);
  ASSERT_TRUE(rig.robot->drive()->start({0.3, 0.0, 0.1}));
  const HandLook look = guide.look();
  EXPECT_TRUE(look.has_markers);
  EXPECT_EQ(look.instruction.kind, Kind::Goal);
  EXPECT_NEAR(look.instruction.distance, 0.3, 1e-9);
  ASSERT_TRUE(look.pose);
  EXPECT_NEAR(look.pose->x, 1.2, 1e-9);
  EXPECT_NEAR(look.pose->theta, 0.5, 1e-9);
  ASSERT_NE(look.frame, nullptr);
  EXPECT_EQ(look.frame->width, 64);
  ASSERT_EQ(look.markers.size(), 1U);
  EXPECT_EQ(look.markers[0].id, 17);
  EXPECT_EQ(look.markers[0].corners[2], (Vec2{9, 10}));
}

TEST(HandGuide, SaysThatTheRobotIsLostAndWhy) {
  const HandRig rig;
  rig.wait(0.1);
  rig.hand->is_lost = true;
  rig.wait(1.0);
  const HandLook look = rig.robot->hand_guide()->look();
  EXPECT_EQ(look.instruction.kind, Kind::Lost);
  EXPECT_THAT(look.instruction.reason, HasSubstr("no marker"));
  EXPECT_FALSE(look.pose);
  EXPECT_NE(look.frame, nullptr) << "the picture goes on";
}

TEST(HandGuide, AnUncertainHeadingSwingsTheRobotRoundItsCamera) {
  const HandRig rig;
  const double ahead = rig.hand->camera_in_robot.x;
  ASSERT_GT(ahead, 0.01) << "the camera is in front of the robot's middle";
  const double heading = 0.02;  // standard deviation, rad
  rig.hand->covariance = {1e-6, 0, 0, 0, 4e-6, 0, 0, 0, heading * heading};
  rig.put({1.0, 1.0, 0.0});
  rig.wait(0.1);
  const HandLook look = rig.robot->hand_guide()->look();
  // Looking along +x, the robot's middle swings sideways only.
  EXPECT_NEAR(look.covariance[0], 1e-6, 1e-12);
  EXPECT_NEAR(look.covariance[4], 4e-6 + std::pow(ahead * heading, 2), 1e-12);
  EXPECT_NEAR(look.covariance[5], -ahead * heading * heading, 1e-12);
  EXPECT_NEAR(look.covariance[5], look.covariance[7], 1e-15);
  EXPECT_NEAR(look.covariance[8], heading * heading, 1e-15);
}

TEST(HandGuide, WithoutMarkersShowsWhatTheProgramCommands) {
  Rig rig = lockstep_rig(facing(1.0));
  rig.backend =
      with_shown_drive(std::move(rig.backend), std::make_unique<HandEye>(std::make_shared<Hand>()));
  ASSERT_TRUE(rig.backend->drive()->start({0.0, 1.0, 0.5}));
  const HandGuide* const guide = rig.backend->hand_guide();
  ASSERT_NE(guide, nullptr);
  const HandLook look = guide->look();
  EXPECT_FALSE(look.has_markers);
  EXPECT_FALSE(look.pose);
  EXPECT_EQ(look.frame, nullptr);
  EXPECT_EQ(look.instruction.kind, Kind::Goal);
  EXPECT_NEAR(look.instruction.angle, 1.0, 1e-6);
}

}  // namespace
}  // namespace eyebridge::hal
