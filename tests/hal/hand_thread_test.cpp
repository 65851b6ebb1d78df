// A camera's thread, the world's and the program's at once: in real time, made fast.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hand_rig.hpp"

namespace eyebridge::hal {
namespace {

Rig quick_rig() { return sim_rig(facing(1.0), {{"factor", "20"}}); }

TEST(HandThreads, AMovementIsMadeWhileTheCameraRunsByItself) {
  const HandRig rig(quick_rig());
  ASSERT_TRUE(rig.robot->drive()->start({0.3, 0.0, 0.2}));
  EXPECT_EQ(rig.wait_for_drive().value().progress, DriveProgress::Done);
  EXPECT_GT(rig.robot->drive()->odometry().value().x, 0.25);
  EXPECT_TRUE(rig.robot->range_sensor(1)->read());
}

TEST(HandThreads, TheProgramGetsFramesBesideTheFinder) {
  const HandRig rig(quick_rig());
  camera::Source* source = rig.robot->camera_source();
  ASSERT_TRUE(source->set_size(32, 24));
  std::optional<std::uint64_t> last;
  for (int i = 0; i < 10; ++i) {
    const auto frame = source->next(rig.robot->clock().now() + std::chrono::seconds(20));
    ASSERT_TRUE(frame) << frame.error().what;
    EXPECT_EQ((*frame)->width, 32);
    if (last) {
      EXPECT_GT((*frame)->sequence, *last);
    }
    last = (*frame)->sequence;
  }
}

TEST(HandThreads, ARobotThatIsLostIsAnErrorInTheEnd) {
  const HandRig rig(quick_rig());
  {
    const std::lock_guard lock(rig.hand->mutex);
    rig.hand->is_lost = true;
  }
  // Frames that were on their way still showed it.
  Clock& clock = rig.robot->clock();
  bool is_error = false;
  for (int i = 0; i < 2000 && !is_error; ++i) {
    is_error = !rig.robot->range_sensor(1)->read();
    clock.wait_until(clock.now() + std::chrono::milliseconds(10));
  }
  EXPECT_TRUE(is_error);
}

TEST(HandThreads, EndsWhileTheCameraGivesFrames) {
  for (int i = 0; i < 5; ++i) {
    const HandRig rig(quick_rig());
    EXPECT_TRUE(rig.robot->range_sensor(1)->read());
  }
}

}  // namespace
}  // namespace eyebridge::hal
