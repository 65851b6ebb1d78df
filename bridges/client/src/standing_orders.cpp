#include "standing_orders.hpp"

#include <algorithm>

namespace eyebridge::bridges {
namespace {

constexpr int kSpeed = IO7_MOTOR_LAST;  // the index of v-omega, behind those of the motors

/// Where `request` is remembered; -1 where it is not.
int index_of(const io7::Request& request) {
  const int id = request.arguments[0];
  switch (request.letter) {
    case IO7_MOTOR:
    case IO7_MOTOR_SPEED:
      return id - IO7_MOTOR_FIRST;
    case IO7_VW_SET_SPEED:
      return kSpeed;
    case IO7_SERVO:
      return kSpeed + 1 + id - IO7_SERVO_FIRST;
    case IO7_DIGITAL_OUT:
      return kSpeed + 1 + IO7_SERVO_LAST + id - IO7_PORT_FIRST;
    default:
      return -1;
  }
}

}  // namespace

bool is_movement(char letter) {
  return letter == IO7_VW_STRAIGHT || letter == IO7_VW_TURN || letter == IO7_VW_CURVE;
}

void StandingOrders::note(const io7::Request& request, Time now) {
  const int index = index_of(request);
  if (is_movement(request.letter) || index == kSpeed) {
    std::fill_n(orders_.begin(), kMotors, Order{});
  } else if (index >= 0 && index < kSpeed) {
    orders_[kSpeed] = Order{};
  }
  if (index >= 0) orders_[static_cast<std::size_t>(index)] = {request, now};
}

const io7::Request* StandingOrders::due(Time now) {
  for (std::size_t i = 0; i < orders_.size(); ++i) {
    Order& order = orders_[i];
    const Time period = i < kMotors ? kMotorPeriod : kOtherPeriod;
    if (order.request.letter == 0 || now - order.sent < period) continue;
    order.sent = now;
    return &order.request;
  }
  return nullptr;
}

Time StandingOrders::next_motor() const {
  Time next = Time::max();
  for (std::size_t i = 0; i < kMotors; ++i) {
    if (orders_[i].request.letter == 0) continue;
    next = std::min(next, orders_[i].sent + kMotorPeriod);
  }
  return next;
}

}  // namespace eyebridge::bridges
