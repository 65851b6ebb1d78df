#pragma once

#include <mutex>

#include "board/board_tables.hpp"
#include "board/drive_controller.hpp"
#include "eyebridge/bridges/client/io7_client.hpp"

namespace eyebridge::hal {

/// v-omega by the letters of an IO7 board: whole millimetres and degrees.
class Io7Drive final : public DriveController {
 public:
  /// `client` must outlive this.
  Io7Drive(bridges::Io7Client& client, const BoardDriveShape& shape)
      : client_(client), shape_(shape) {}

  Result<void> set_speed(const Twist& twist) override;
  Result<void> start(const DriveGoal& goal) override;
  Result<DriveStatus> status() override;
  Result<Twist> measured_twist() override;
  Result<Pose> odometry() override;
  Result<void> set_odometry(const Pose& pose) override;
  void release() override { set(Mode::Free); }
  void restarted() override;

 private:
  enum class Mode { Free, Goal, Failed };
  void set(Mode mode);
  Result<void> tell(const bridges::io7::Request& request, Mode mode);

  bridges::Io7Client& client_;
  const BoardDriveShape shape_;
  std::mutex mutex_;
  Mode mode_ = Mode::Free;
};

}  // namespace eyebridge::hal
