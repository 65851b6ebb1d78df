// Without markers: the simulated robot drives, and the person is shown what it does.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hand/shown_drive.hpp"
#include "hand_person.hpp"
#include "rigs.hpp"

namespace eyebridge::hal {
namespace {

struct FreeRig {
  std::shared_ptr<Hand> hand = std::make_shared<Hand>();
  Rig rig = lockstep_rig(facing(1.0));

  FreeRig() {
    rig.backend = with_shown_drive(std::move(rig.backend), std::make_unique<HandEye>(hand));
  }
  [[nodiscard]] std::string told() const { return in_words(hand->told); }
};

TEST(HandFree, TheRobotDrivesAsEverAndItsWayIsShown) {
  const FreeRig free;
  Drive& drive = *free.rig.backend->drive();
  ASSERT_TRUE(drive.start({0.5, 0.0, 0.2}));
  EXPECT_EQ(free.told(), "forward 0.50 m at 0.20 m/s");
  free.rig.wait(1.0);
  ASSERT_TRUE(drive.status());
  EXPECT_EQ(free.told().substr(0, 10), "forward 0.");
  EXPECT_NEAR(free.hand->told.distance, drive.status().value().remaining, 1e-9);
  EXPECT_EQ(free.rig.wait_for_drive().progress, DriveProgress::Done);
  EXPECT_EQ(free.told(), "stand still");
  EXPECT_NEAR(free.rig.backend->range_sensor(1)->read().value(), 0.5, 1e-3);
}

TEST(HandFree, TurnsAndSpeedsAreShown) {
  const FreeRig free;
  Drive& drive = *free.rig.backend->drive();
  ASSERT_TRUE(drive.start({0.0, deg_to_rad(-90), deg_to_rad(45)}));
  EXPECT_EQ(free.told(), "turn right 90 deg at 45 deg/s");
  ASSERT_TRUE(drive.set_speed({-0.1, 0.0}));
  EXPECT_EQ(free.told(), "backward at 0.10 m/s");
  free.rig.backend->stop();
  EXPECT_EQ(free.told(), "stand still");
}

TEST(HandFree, AMovementThatARobotGivesUpIsNotShownForEver) {
  const FreeRig free;
  ASSERT_TRUE(free.rig.backend->drive()->start({2.0, 0.0, 0.5}));
  EXPECT_EQ(free.rig.wait_for_drive().progress, DriveProgress::Failed);
  EXPECT_EQ(free.told(), "stand still");
}

}  // namespace
}  // namespace eyebridge::hal
