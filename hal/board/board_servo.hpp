#pragma once

#include "board/board_device.hpp"
#include "eyebridge/hal/servo.hpp"

namespace eyebridge::hal {

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
