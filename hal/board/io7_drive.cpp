#include "board/io7_drive.hpp"

#include <algorithm>
#include <cmath>

#include "board/board_units.hpp"
#include "eyebridge/base/units.hpp"
#include "opcodes.h"

namespace eyebridge::hal {
namespace {

using bridges::io7::Reply;
using bridges::io7::request;

}  // namespace

void Io7Drive::set(Mode mode) {
  const std::lock_guard lock(mutex_);
  mode_ = mode;
}

void Io7Drive::restarted() {
  const std::lock_guard lock(mutex_);
  if (mode_ == Mode::Goal) mode_ = Mode::Failed;
}

Result<void> Io7Drive::tell(const bridges::io7::Request& what, Mode mode) {
  return client_.exchange(what).map([&](const Reply&) { set(mode); });
}

Result<void> Io7Drive::set_speed(const Twist& twist) {
  const Twist allowed = clamped(twist, shape_);
  return tell(request(IO7_VW_SET_SPEED, to_mm(allowed.linear), to_degrees(allowed.angular)),
              Mode::Free);
}

Result<void> Io7Drive::start(const DriveGoal& goal) {
  const int distance = to_mm(goal.distance);
  const int angle = to_degrees(goal.angle);
  if ((distance == 0 && angle == 0) || goal.speed == 0) return set_speed({});
  if (distance == 0) {
    const int speed = to_degrees(std::min(goal.speed, shape_.max_angular));
    return tell(request(IO7_VW_TURN, std::max(speed, 1), angle), Mode::Goal);
  }
  const int speed = std::max<int>(to_mm(std::min(goal.speed, shape_.max_linear)), 1);
  if (angle == 0) return tell(request(IO7_VW_STRAIGHT, speed, distance), Mode::Goal);
  return tell(request(IO7_VW_CURVE, distance, angle, speed), Mode::Goal);
}

Result<DriveStatus> Io7Drive::status() {
  const Mode mode = [this] {
    const std::lock_guard lock(mutex_);
    return mode_;
  }();
  DriveStatus status;
  const auto done = client_.exchange(request(IO7_VW_DONE));
  if (!done) return tl::unexpected(done.error());
  const int state = done->values[0];
  const bool given_up = mode == Mode::Goal && state < 0;
  if (mode == Mode::Failed || given_up) status.progress = DriveProgress::Failed;
  if (mode != Mode::Goal || state != 0) return status;
  status.progress = DriveProgress::Driving;
  if (!client_.has(IO7_VW_REMAINING)) return status;
  return client_.exchange(request(IO7_VW_REMAINING)).map([&](const Reply& left) {
    status.remaining = std::abs(mm_to_m(left.values[0]));
    return status;
  });
}

Result<Twist> Io7Drive::measured_twist() {
  return client_.exchange(request(IO7_VW_GET_SPEED)).map([](const Reply& speed) {
    return Twist{mm_to_m(speed.values[0]), deg_to_rad(speed.values[1])};
  });
}

Result<Pose> Io7Drive::odometry() {
  return client_.exchange(request(IO7_VW_GET_POSE)).map([](const Reply& pose) {
    return Pose{mm_to_m(pose.values[0]), mm_to_m(pose.values[1]),
                wrap_angle(deg_to_rad(pose.values[2]))};
  });
}

Result<void> Io7Drive::set_odometry(const Pose& pose) {
  return client_
      .exchange(request(IO7_VW_SET_POSE, to_mm(pose.x), to_mm(pose.y), to_degrees(pose.theta)))
      .map([](const Reply&) {});
}

}  // namespace eyebridge::hal
