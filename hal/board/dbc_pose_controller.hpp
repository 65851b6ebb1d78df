#pragma once

#include <mutex>
#include <optional>

#include "board/drive_controller.hpp"
#include "board/host_controller.hpp"

namespace eyebridge::hal {

class DbcLink;

/// v-omega on the host, for a robot that knows itself where it is: its pose is the odometry.
class DbcPoseController final : public DriveController {
 public:
  /// As HostController. `link` has a pose.
  DbcPoseController(DbcLink& link, Clock& clock, const BoardDriveShape& shape);

  Result<void> set_speed(const Twist& twist) override { return host_.set_speed(twist); }
  Result<void> start(const DriveGoal& goal) override { return host_.start(goal); }
  Result<DriveStatus> status() override { return host_.status(); }
  Result<Twist> measured_twist() override { return host_.measured_twist(); }
  Result<Pose> odometry() override;
  Result<void> set_odometry(const Pose& pose) override;
  void release() override { host_.release(); }
  /// The robot may count its pose from 0 again; the odometry goes on where it was.
  void restarted() override;
  void step() override { host_.step(); }

 private:
  DbcLink& link_;
  HostController host_;
  std::mutex mutex_;
  Pose origin_;               ///< Of the robot's own poses, in the odometry.
  std::optional<Pose> last_;  ///< The odometry, as asked last.
  bool is_moved_ = false;     ///< The origin is to be found again.
};

}  // namespace eyebridge::hal
