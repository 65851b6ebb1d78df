#include "board/board_servo.hpp"

#include "board/board_units.hpp"

namespace eyebridge::hal {

Result<void> BoardServo::set(double position) {
  return require(position >= 0.0 && position <= 1.0, "servo", position, "a position of 0 … 1")
      .and_then([&] { return link_.servo(id_, to_servo_position(table_, position)); });
}

}  // namespace eyebridge::hal
