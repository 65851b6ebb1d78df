#include "motor.hpp"

#include <algorithm>
#include <cmath>

namespace eyebridge::robot {
namespace {

// The board's controller runs at 100 Hz; the scale of its gains is not documented. With these the
// default gains 4, 1, 1 settle with little overshoot for lags of 1 ms to 1 s.
constexpr double kPeriod = 0.01;
constexpr double kScale = 1.0 / 32.0;
constexpr double kIntegralScale = 1.0 / 128.0;

}  // namespace

double decay_of(double x) {
  if (x > 700.0) return 0.0;
  int halvings = 0;
  for (; x > 0.25; x /= 2) ++halvings;
  double sum = 1.0;
  for (int n = 12; n >= 1; --n) sum = 1.0 - x / n * sum;
  for (; halvings > 0; --halvings) sum *= sum;
  return sum;
}

double Wheel::drive(double speed, const MotorModel& model) {
  const double end = std::clamp(speed, -model.top, model.top);
  // Exact solution of T v' = end - v over the step, and its integral.
  const double difference = speed_ - end;
  speed_ = end + difference * model.decay;
  last_target_ = speed_;
  return end * model.dt + difference * model.lag;
}

double Wheel::drive_controlled(double speed, const MotorModel& model) {
  const double target = std::clamp(speed, -model.top, model.top);
  const double error = last_target_ - speed_;
  if (error == 0.0 && last_error_ == 0.0 && integral_ == 0.0) {
    const double travel = drive(target, model);
    last_target_ = target;
    return travel;
  }
  const double periods = model.dt / kPeriod;
  // Standing still is not aimed at but braked to: what the integral gathered on the way would
  // drive the wheel past it.
  const double integral = target == 0.0 ? 0.0 : integral_ + error * periods;
  const double correction =
      kScale * (gains_.p * error + gains_.d * (error - last_error_) / periods) +
      kIntegralScale * gains_.i * integral;
  const double asked = target + correction;
  // A motor that is at its limit must not wind the integral up.
  if (std::abs(asked) <= model.top) integral_ = integral;
  last_error_ = error;
  const double travel = drive(asked, model);
  last_target_ = target;
  return travel;
}

void Wheel::turn(double travel, bool held, const MotorModel& model) {
  travel_ += travel;
  if (!held) return;
  halt();
  speed_ = last_target_ = travel / model.dt;
}

void Wheel::halt() {
  speed_ = 0.0;
  last_target_ = 0.0;
  last_error_ = 0.0;
  integral_ = 0.0;
}

double Wheel::rolling(const MotorModel& model) const {
  return speed_ * model.time_constant / (1.0 + kScale * gains_.p);
}

std::int64_t Wheel::raw_ticks(const MotorModel& model) const {
  return std::llround(travel_ * model.ticks_per_metre) - missed_ticks_;
}

}  // namespace eyebridge::robot
