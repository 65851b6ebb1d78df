#include "board/board_actuators.hpp"

#include "arguments/arguments.hpp"
#include "board/board_units.hpp"

namespace eyebridge::hal {

Result<void> BoardMotor::set_duty(double duty) {
  return check_duty(duty).and_then([&] {
    if (drive_ != nullptr) drive_->release();
    return link_.motor_duty(id_, to_percent(table_, reversed_ ? -duty : duty));
  });
}

Result<void> BoardMotor::set_speed(double ticks_per_second) {
  return check_motor_speed(ticks_per_second).and_then([&] {
    if (drive_ != nullptr) drive_->release();
    return link_.motor_speed(id_,
                             to_ticks_per_10ms(reversed_ ? -ticks_per_second : ticks_per_second));
  });
}

Result<void> BoardMotor::set_pid(int p, int i, int d) {
  return check_gains(p, i, d).and_then([&] { return link_.motor_pid(id_, p, i, d); });
}

Result<int> BoardEncoder::read() {
  return link_.encoder(id_).map([this](const BoardCount& count) {
    const auto counted = static_cast<std::uint32_t>(count.ticks);
    const std::lock_guard lock(mutex_);
    return static_cast<int>(static_cast<std::int32_t>((reversed_ ? 0 - counted : counted) - zero_));
  });
}

Result<void> BoardEncoder::reset() {
  return link_.encoder(id_).map([this](const BoardCount& count) {
    const auto counted = static_cast<std::uint32_t>(count.ticks);
    const std::lock_guard lock(mutex_);
    zero_ = reversed_ ? 0 - counted : counted;
  });
}

Result<void> BoardServo::set(double position) {
  return check_servo_position(position).and_then(
      [&] { return link_.servo(id_, to_servo_position(table_, position)); });
}

}  // namespace eyebridge::hal
