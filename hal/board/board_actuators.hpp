#pragma once

#include <mutex>

#include "board/board_device.hpp"
#include "eyebridge/hal/motor.hpp"
#include "eyebridge/hal/servo.hpp"

namespace eyebridge::hal {

/// One motor of a board.
class BoardMotor final : public Motor, private BoardDevice {
 public:
  /// `drive` may be null; it is told when the motor is used without it.
  BoardMotor(BoardLink& link, BoardMotorTable table, bool reversed, DriveController* drive)
      : BoardDevice(link, table.id), table_(std::move(table)), reversed_(reversed), drive_(drive) {}

  Result<void> set_duty(double duty) override;
  Result<void> set_speed(double ticks_per_second) override;
  Result<void> set_pid(int p, int i, int d) override;

 private:
  const BoardMotorTable table_;
  const bool reversed_;
  DriveController* const drive_;
};

/// Its encoder. Resets are the host's: no board has a request for it.
class BoardEncoder final : public Encoder, private BoardDevice {
 public:
  BoardEncoder(BoardLink& link, int id, bool reversed)
      : BoardDevice(link, id), reversed_(reversed) {}

  Result<int> read() override;
  Result<void> reset() override;

 private:
  const bool reversed_;
  std::mutex mutex_;
  std::uint32_t zero_ = 0;
};

/// One servo of a board.
class BoardServo final : public Servo, private BoardDevice {
 public:
  BoardServo(BoardLink& link, BoardServoTable table)
      : BoardDevice(link, table.id), table_(std::move(table)) {}

  Result<void> set(double position) override;

 private:
  const BoardServoTable table_;
};

}  // namespace eyebridge::hal
