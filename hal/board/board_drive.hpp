#pragma once

#include "board/drive_controller.hpp"
#include "eyebridge/hal/drive.hpp"

namespace eyebridge::hal {

/// The v-omega drive of a board: checks what it is asked for; a controller does it.
class BoardDrive final : public Drive {
 public:
  explicit BoardDrive(DriveController& controller) : controller_(controller) {}

  Result<void> set_speed(const Twist& twist) override;
  Result<void> start(const DriveGoal& goal) override;
  Result<DriveStatus> status() override { return controller_.status(); }
  Result<Twist> measured_twist() override { return controller_.measured_twist(); }
  Result<Pose> odometry() override { return controller_.odometry(); }
  Result<void> set_odometry(const Pose& pose) override;

 private:
  DriveController& controller_;
};

}  // namespace eyebridge::hal
