#pragma once

#include <atomic>
#include <mutex>
#include <optional>

#include "board/board_tables.hpp"
#include "board/drive_controller.hpp"
#include "eyebridge/bridges/client/can_client.hpp"

namespace eyebridge::hal {

/// v-omega on a robot that is on a CAN bus: the robot does it.
class CanDrive final : public DriveController {
 public:
  /// `client` must outlive this.
  CanDrive(bridges::CanClient& client, const BoardDriveShape& shape)
      : client_(client), shape_(shape), restored_(client.restarts()), restarts_(restored_) {}

  /// How long a robot may have told a pose from 0 on before its restart is noticed.
  static constexpr Time kRestartTime = std::chrono::milliseconds(150);

  Result<void> set_speed(const Twist& twist) override;
  Result<void> start(const DriveGoal& goal) override;
  Result<DriveStatus> status() override;
  Result<Twist> measured_twist() override;
  Result<Pose> odometry() override;
  Result<void> set_odometry(const Pose& pose) override;
  void release() override { set(Mode::Free); }
  void restarted() override;
  /// Tells a robot that has forgotten it where it was last.
  void step() override;

 private:
  enum class Mode { Free, Goal, Failed };
  void set(Mode mode);
  [[nodiscard]] std::optional<Pose> pose_before_restart() const;
  [[nodiscard]] Result<Pose> told_pose() const;

  bridges::CanClient& client_;
  const BoardDriveShape shape_;
  std::atomic<std::uint32_t>
      restored_;  ///< The restart of the client after which the robot knows its pose again.
  std::mutex mutex_;
  Mode mode_ = Mode::Free;
  std::uint32_t goal_generation_ = 0;  ///< Of the client, when the goal was set.
  // Only the board's thread:
  std::uint32_t restarts_;      ///< Of the client, which this knows of.
  std::optional<Pose> recent_;  ///< As told last.
  std::optional<Pose> middle_;  ///< Up to kRestartTime before that …
  std::optional<Pose> older_;   ///< … and up to as long before again.
  std::optional<Pose> to_restore_;
  int steps_ = 0;
};

}  // namespace eyebridge::hal
