#include "eyebridge/robot/drive_controller.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace eyebridge::robot {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRounding = 1.0 + 1e-9;
// Ends of a goal that the heading may lack. More than that was not the drive's doing: somebody
// turned the robot by hand.
constexpr double kMostOwed = 10.0;
constexpr double kPlannedBraking = 0.7;  // of what the robot can, where speeds may come late
// Of what is left, in one step, over a slow line. What the steps before brought is only predicted,
// and boards differ in when they obey: a whole share would correct the prediction's own error, and
// the robot would go to and fro.
constexpr double kBlindShare = 0.5;

/// Narrows [low, high] to the factors f for which f * amount is one step of speed from `speed`.
void narrow(double amount, double speed, double speed_step, double& low, double& high) {
  if (amount == 0.0) {
    if (std::abs(speed) > speed_step) high = -kInfinity;  // no factor does it
    return;
  }
  const double a = (speed - speed_step) / amount;
  const double b = (speed + speed_step) / amount;
  low = std::max(low, std::min(a, b));
  high = std::min(high, std::max(a, b));
}

}  // namespace

void DriveController::Part::set(double amount) {
  open = amount != 0.0;
  left = amount;
  side = amount;
}

void DriveController::Part::advance(double travelled, double speed, double step, double end,
                                    const DriveLimits& limits) {
  if (!open) return;
  left -= travelled;
  // A start too fast for a short goal runs past it and comes back: only slow passing counts, and
  // none where a step leads far.
  const double slow_speed = limits.blind ? std::min(step, end / (limits.dt * limits.held)) : step;
  const bool slow = std::abs(speed) <= slow_speed * kRounding;
  const bool passed = !limits.blind && left * side < 0.0;
  if (slow && (std::abs(left) <= end || passed)) open = false;
  if (left != 0.0) side = left < 0.0 ? -1.0 : 1.0;
}

void DriveController::set_speed(const Twist& target, const Twist& present) {
  target_ = clamp_twist(target, limits_);
  twist_ = present;
  distance_.set(0.0);
  angle_.set(0.0);
  keeps_heading_ = false;
  state_ = DriveState::Idle;
}

double DriveController::settle_heading(double angle) {
  const bool kept = keeps_heading_ && state_ != DriveState::Driving &&
                    std::abs(heading_owed_) <= kMostOwed * limits_.angle_end;
  heading_owed_ = (kept ? heading_owed_ : 0.0) + angle;
  keeps_heading_ = true;
  return angle == 0.0 ? 0.0 : heading_owed_;
}

void DriveController::start(const DriveGoal& goal, const Twist& present) {
  const double speed = std::abs(goal.speed);
  if (speed == 0.0 || (goal.distance == 0.0 && goal.angle == 0.0)) {
    // Runs out as after set_speed(): programs that steer give a turn of 0 degrees before each
    // straight.
    set_speed({}, present);
    return;
  }
  const bool on_the_spot = goal.distance == 0.0;
  linear_top_ = on_the_spot ? limits_.linear : std::min(speed, limits_.linear);
  angular_top_ = on_the_spot ? std::min(speed, limits_.angular) : limits_.angular;
  distance_.set(goal.distance);
  angle_.set(settle_heading(goal.angle));
  target_ = {};
  twist_ = present;
  state_ = DriveState::Driving;
}

void DriveController::stop() {
  target_ = {};
  twist_ = {};
  distance_.set(0.0);
  angle_.set(0.0);
  keeps_heading_ = false;
  state_ = DriveState::Idle;
}

void DriveController::fail() {
  stop();
  state_ = DriveState::Failed;
}

Twist DriveController::next(const PathStep& rolling) {
  if (state_ == DriveState::Driving) {
    double distance = distance_.open ? distance_.left - rolling.distance : 0.0;
    double angle = angle_.open ? angle_.left - rolling.angle : 0.0;
    if (limits_.blind && std::abs(distance) <= limits_.distance_end) distance = 0.0;
    if (limits_.blind && std::abs(angle) <= limits_.angle_end) angle = 0.0;
    twist_ = towards_goal(distance, angle);
  } else {
    twist_ = approach(twist_, target_, limits_);
  }
  return twist_;
}

Twist DriveController::towards_goal(double distance, double angle) const {
  if (distance == 0.0 && angle == 0.0) return approach(twist_, {}, limits_);
  // Both parts go on in proportion, so that they end together and a curve is one arc: everything
  // is a factor f (per second) with which the remaining distance and angle become the twist.
  const double d = std::abs(distance);
  const double a = std::abs(angle);
  double share = kInfinity;  // see stopping_share()
  double top = limits_.wheel / (d + a * limits_.half_base);
  const double hold = limits_.dt * limits_.held;
  // Late speeds brake late, too: some of the deceleration is kept for that.
  const double holds = limits_.held > 1.0 ? kPlannedBraking * limits_.held * limits_.held : 1.0;
  if (d > 0.0) {
    share = limits_.dt * limits_.linear_step * holds / d;
    top = std::min(top, linear_top_ / d);
  }
  if (a > 0.0) {
    share = std::min(share, limits_.dt * limits_.angular_step * holds / a);
    top = std::min(top, angular_top_ / a);
  }
  double factor = top;
  // Stopping from f covers at most f^2 dt^2 / (2 share) + f dt of what is left: far from the goal
  // there is no need to know it exactly.
  const double step = top * hold;
  if (step > 1.0 || step * (step + 2 * share) > 2 * share) {
    factor = std::min(top, stopping_share(share) / hold);
  }
  if (limits_.blind) factor = std::min(factor, kBlindShare / hold);
  double low = -kInfinity;
  double high = kInfinity;
  narrow(distance, twist_.linear, limits_.linear_step, low, high);
  narrow(angle, twist_.angular, limits_.angular_step, low, high);
  if (low <= high) factor = std::clamp(factor, low, high);
  return approach(twist_, {factor * distance, factor * angle}, limits_);
}

void DriveController::advance(const PathStep& measured) {
  heading_owed_ -= measured.angle;
  if (state_ != DriveState::Driving) return;
  distance_.advance(measured.distance, twist_.linear, limits_.linear_step, limits_.distance_end,
                    limits_);
  angle_.advance(measured.angle, twist_.angular, limits_.angular_step, limits_.angle_end, limits_);
  const bool can_stand = std::abs(twist_.linear) <= limits_.linear_step * kRounding &&
                         std::abs(twist_.angular) <= limits_.angular_step * kRounding;
  if (!distance_.open && !angle_.open && can_stand) state_ = DriveState::Idle;
}

void DriveController::hold(const PathStep& measured, bool turns) {
  twist_ = {0.0, turns ? twist_.angular : 0.0};
  advance(measured);
}

double DriveController::remaining() const {
  return distance_.open ? std::abs(distance_.left) : 0.0;
}

}  // namespace eyebridge::robot
