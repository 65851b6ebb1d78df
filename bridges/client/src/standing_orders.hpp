#pragma once

#include <array>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/bridges/io7/request.hpp"

namespace eyebridge::bridges {

/// Whether `letter` moves the robot by so much: nobody may send it twice who does not know whether
/// it arrived.
bool is_movement(char letter);

/// What a board was told last and should be doing now: speeds of motors, positions of servos,
/// levels of outputs. Nothing answers such a request, so nobody can know whether it arrived as it
/// was sent; repeating it undoes what a spoiled byte did, to this device or to another one.
/// Pure: no I/O, no allocation.
class StandingOrders {
 public:
  /// Motors are repeated once in a period of the board's controller, the others in passing.
  static constexpr Time kMotorPeriod = std::chrono::milliseconds(10);
  static constexpr Time kOtherPeriod = std::chrono::milliseconds(200);

  /// `request` was sent at `now`. A motor that is told something new forgets what it was told; who
  /// drives by v and omega has none that is told by itself, and a movement cannot be repeated.
  void note(const io7::Request& request, Time now);

  /// One that was not sent for a period; it counts as sent now. Null when there is none.
  const io7::Request* due(Time now);
  /// When due() has the next motor; Time::max() when there is none to repeat.
  [[nodiscard]] Time next_motor() const;

 private:
  struct Order {
    io7::Request request;
    Time sent{0};
  };
  static constexpr int kMotors = IO7_MOTOR_LAST + 1;  // and v-omega
  static constexpr int kOrders = kMotors + IO7_SERVO_LAST + IO7_PORT_LAST + 1;

  std::array<Order, kOrders> orders_;
};

}  // namespace eyebridge::bridges
