// All of it together: a person who obeys carries a camera through a marked maze, whose pictures the
// pose finder reads; the program drives, and its sensors see the maze.
#include <cstdio>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eyebridge/camera/convert.hpp"
#include "eyebridge/camera/view.hpp"
#include "hand/hand_backend.hpp"
#include "hand_person.hpp"
#include "rigs.hpp"
#include "sim/open_sim.hpp"
#include "wall_picture.hpp"

namespace eyebridge::hal {
namespace {

constexpr camera::Size kSize{640, 480};
const double kFieldOfView = deg_to_rad(60);
// Small enough to be seen whole from 120 mm, where a lens is that faces the wall of a cell.
constexpr camera::FiducialLayout kLayout{.size = 0.05};

/// What the person's camera sees, 30 times a second: the person walks, then the maze is painted.
class WalkerCamera final : public camera::Source {
 public:
  WalkerCamera(Clock& clock, std::shared_ptr<Hand> hand, const world::WorldModel& maze,
               const std::vector<camera::Fiducial>& fiducials)
      : plain_(clock, std::make_shared<std::optional<Error>>()),
        hand_(hand),
        walker_(std::move(hand)),
        painter_(maze, fiducials) {}

  Result<void> set_size(int, int) override { return {}; }
  [[nodiscard]] camera::Size natural_size() const override { return kSize; }
  Result<camera::FramePtr> next(Time deadline) override {
    return plain_.next(deadline).map([&](const camera::FramePtr& plain) {
      (void)walker_.take(*plain);
      camera::Frame frame =
          camera::make_frame(kSize.width, kSize.height, camera::PixelFormat::Grey8);
      frame.time = plain->time;
      frame.sequence = plain->sequence;
      const Pose at = transform(hand_->robot, hand_->camera_in_robot);
      camera::EyePose eye;
      eye.values[camera::kX] = at.x;
      eye.values[camera::kY] = at.y;
      eye.values[camera::kZ] = 0.1;
      eye.values[camera::kHeading] = at.theta;
      const auto light = painter_.paint(eye, lens_);
      std::transform(light.begin(), light.end(), frame.bytes.begin(), [&](float value) {
        const double noisy = value + 3.0 * random_.gaussian();
        return static_cast<std::uint8_t>(std::clamp(noisy, 0.0, 255.0));
      });
      return std::make_shared<const camera::Frame>(std::move(frame));
    });
  }

 private:
  PlainCamera plain_;
  std::shared_ptr<Hand> hand_;
  PersonFinder walker_;
  camera::testing::WallPainter painter_;
  camera::Calibration lens_ = camera::pinhole(kSize, kFieldOfView);
  Random random_{11};
};

struct MazeRig {
  std::shared_ptr<Hand> hand = std::make_shared<Hand>();
  KeepingLog log;
  Config config =
      rig_config({{"world", EYEBRIDGE_SOURCE_DIR "/worlds/maze-5.maz"}, {"fast", "true"}});
  std::unique_ptr<Backend> ghost = open_maze();  ///< Stands where the hand is.
  std::unique_ptr<Backend> robot;

  MazeRig() {
    auto inner = open_maze();
    // Between two walls no marker is in view; who goes on turning finds the next.
    hand->walks_on = true;
    hand->robot = inner->world()->robot_pose(0).value();
    const camera::Eye eye = inner->camera_view()->eye();
    hand->camera_in_robot = relative_to(hand->robot, {eye.x, eye.y, eye.heading});
    const world::WorldModel maze = *inner->camera_view()->scene().model;
    const auto fiducials = camera::place_fiducials(maze, kLayout);
    HandParts parts;
    parts.camera = std::make_unique<WalkerCamera>(inner->clock(), hand, maze, fiducials);
    parts.finder =
        camera::make_fiducial_finder(fiducials, camera::pinhole(kSize, kFieldOfView), log);
    parts.display = std::make_unique<HandEye>(hand);
    robot = make_hand(std::move(inner), std::move(parts));
  }

  std::unique_ptr<Backend> open_maze() {
    return open_sim(BackendUrl{"sim", "", {}}, {config, log});
  }

  void drive(const DriveGoal& goal) const {
    must(robot->drive()->start(goal).map([] { return 0; }));
    while (must(robot->drive()->status()).progress == DriveProgress::Driving) {
      robot->clock().wait_until(robot->clock().now() + std::chrono::milliseconds(10));
    }
  }
  /// How far a reading is from what the sensor would see from the true place.
  [[nodiscard]] double error_of(int psd) const {
    must(ghost->world()->set_robot_pose(0, hand->robot).map([] { return 0; }));
    return std::abs(must(robot->range_sensor(psd)->read()) -
                    must(ghost->range_sensor(psd)->read()));
  }
};

TEST(HandWalk, TheRobotIsWhereThePersonIsAndGoesWhereTheProgramWants) {
  const MazeRig rig;
  const Pose start = rig.hand->robot;
  double worst_reading = 0.0;
  for (int leg = 0; leg < 2; ++leg) {
    rig.drive({0.36, 0.0, 0.2});
    for (const int psd : {1, 2, 3}) worst_reading = std::max(worst_reading, rig.error_of(psd));
    rig.drive({0.0, kPi, 1.0});
  }
  const Pose end = rig.hand->robot;
  const double away = norm(end.position() - start.position());
  const double turned = rad_to_deg(std::abs(wrap_angle(end.theta - start.theta)));
  const Pose seen = must(rig.robot->world()->robot_pose(0));
  const double off = norm(seen.position() - end.position());
  std::printf(
      "%.0f s: end %.0f mm and %.1f deg from the goal, robot %.1f mm from the person, worst PSD "
      "%.0f mm\n",
      to_seconds(rig.robot->clock().now()), m_to_mm(away), turned, m_to_mm(off),
      m_to_mm(worst_reading));
  EXPECT_LT(away, 0.035);
  EXPECT_LT(turned, 4.5);
  EXPECT_LT(off, 0.02);
  EXPECT_LT(worst_reading, 0.03);
  EXPECT_THAT(rig.log.messages(Severity::Warning), ::testing::IsEmpty());
}

}  // namespace
}  // namespace eyebridge::hal
