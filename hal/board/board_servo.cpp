#include "board/board_servo.hpp"

#include "arguments/arguments.hpp"
#include "board/board_units.hpp"

namespace eyebridge::hal {

Result<void> BoardServo::set(double position) {
  return check_servo_position(position).and_then(
      [&] { return link_.servo(id_, to_servo_position(table_, position)); });
}

}  // namespace eyebridge::hal
