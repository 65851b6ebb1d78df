#pragma once

#include <array>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "eyebridge/base/result.hpp"
#include "eyebridge/camera/pose_finder.hpp"
#include "eyebridge/camera/shared_source.hpp"
#include "eyebridge/hal/drive.hpp"
#include "eyebridge/hal/hand_guide.hpp"
#include "hand/movement.hpp"

namespace eyebridge::hal {

/// A robot that a person carries: where it is by what its camera sees, and what the program wants
/// of it. Metres, radians; any thread, but one at a time calls the FrameWatcher's side.
///
/// A pose holds until the next frame, at most kFresh; the finder bridges short losses itself.
class CarriedRobot final : public camera::FrameWatcher, public HandGuide {
 public:
  static constexpr Time kFresh = std::chrono::milliseconds(500);

  /// What a carried robot needs; what is a reference is lent.
  struct Parts {
    std::unique_ptr<camera::PoseFinder> finder;
    Pose camera_in_robot;                    ///< Its place and pan on the robot.
    const Clock& clock;                      ///< The robot's.
    std::function<void(const Pose&)> moved;  ///< Told of each pose in the world.
    InstructionSink& display;
  };
  explicit CarriedRobot(Parts parts);

  void frame(const camera::FramePtr& frame) override;
  void no_frame(const Error& why) override;

  [[nodiscard]] HandLook look() const override;

  /// Where the robot is in the world. Fails with Timeout while its camera gives frames that show
  /// no place, and as the camera while that gives none.
  [[nodiscard]] Result<Pose> pose() const;
  /// When it was seen last; zero before the first time.
  [[nodiscard]] Time last_seen() const;
  /// Pose since set_odometry(), by default that of the first pose that was found. Fails as pose().
  [[nodiscard]] Result<Pose> odometry() const;
  /// Over the last poses. Fails as pose(), and with Timeout before the second one.
  [[nodiscard]] Result<Twist> twist() const;
  /// Fails as pose(): a goal is counted from there.
  Result<DriveStatus> status() const;

  Result<void> start(const DriveGoal& goal);
  Result<void> set_odometry(const Pose& pose);
  void set_speed(const Twist& twist);

 private:
  struct Seen {
    Time time{0};
    Pose pose;
  };

  void take(const camera::FramePtr& frame, const std::optional<camera::FoundPose>& found);
  void show();
  // The rest: mutex_ is held.
  [[nodiscard]] Result<Pose> pose_now() const;
  [[nodiscard]] Instruction instruction_now() const;
  [[nodiscard]] Error why_lost() const;

  const std::unique_ptr<camera::PoseFinder> finder_;
  const Pose robot_in_camera_;
  const Clock& clock_;
  const std::function<void(const Pose&)> moved_;
  InstructionSink& display_;

  mutable std::mutex mutex_;
  Movement movement_;
  std::deque<Seen> seen_;     ///< The last poses, the newest last; empty while lost.
  std::optional<Pose> last_;  ///< Where it was seen last, also while lost.
  Time last_seen_{0};
  std::array<double, 9> covariance_{};  ///< Of the last pose.
  camera::FramePtr frame_;
  std::vector<SeenMarker> markers_;  ///< In it.
  std::optional<Time> last_frame_;
  std::optional<Error> no_frame_;          ///< While the camera gives none.
  std::optional<Pose> odometry_in_world_;  ///< Where odometry said …
  Pose odometry_;                          ///< … this.
};

}  // namespace eyebridge::hal
