#include "board/can_drive.hpp"

#include <algorithm>
#include <cmath>

#include "board/board_units.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::hal {
namespace {

namespace can = bridges::can;

constexpr Time kStep = std::chrono::milliseconds(10);

}  // namespace

void CanDrive::set(Mode mode) {
  const std::lock_guard lock(mutex_);
  mode_ = mode;
}

// The restart is noticed after the robot has told its new pose a few times.
std::optional<Pose> CanDrive::pose_before_restart() const {
  if (!recent_ || !older_) return recent_;
  constexpr double kSlack = 0.02;  // metres
  const double possible = 2 * to_seconds(kRestartTime) * shape_.max_linear + kSlack;
  return norm(recent_->position() - older_->position()) <= possible ? recent_ : older_;
}

void CanDrive::restarted() {
  const std::lock_guard lock(mutex_);
  if (mode_ == Mode::Goal) mode_ = Mode::Failed;
}

void CanDrive::step() {
  if (client_.phase() != bridges::RobotWatch::Phase::Ready) return;
  if (client_.restarts() != restarts_) {
    restarts_ = client_.restarts();
    to_restore_ = pose_before_restart();
  }
  if (to_restore_) {
    if (!set_odometry(*to_restore_)) return;
    to_restore_.reset();
  }
  restored_ = restarts_;
  const auto pose = told_pose();
  if (!pose) return;
  if (++steps_ * kStep >= kRestartTime) {
    steps_ = 0;
    older_ = middle_;
    middle_ = recent_;
  }
  recent_ = *pose;
}

Result<void> CanDrive::set_speed(const Twist& twist) {
  const Twist allowed = clamped(twist, shape_);
  return client_.drive(to_mm(allowed.linear), to_centi_degrees(allowed.angular)).map([this] {
    set(Mode::Free);
  });
}

Result<void> CanDrive::start(const DriveGoal& goal) {
  can::MoveCommand move;
  move.distance_mm = to_mm(goal.distance);
  move.angle_ddeg = to_tenth_degrees(goal.angle);
  if ((move.distance_mm == 0 && move.angle_ddeg == 0) || goal.speed == 0) return set_speed({});
  const bool turn = move.distance_mm == 0;
  const int speed = turn ? to_degrees(std::min(goal.speed, shape_.max_angular))
                         : to_mm(std::min(goal.speed, shape_.max_linear));
  move.speed = static_cast<std::int16_t>(std::max(speed, 1));
  move.type = turn ? EYECAN_VW_TURN : move.angle_ddeg == 0 ? EYECAN_VW_STRAIGHT : EYECAN_VW_CURVE;
  const std::uint32_t generation = client_.generation();
  return client_.move(move).map([&] {
    const std::lock_guard lock(mutex_);
    mode_ = Mode::Goal;
    goal_generation_ = generation;
  });
}

Result<DriveStatus> CanDrive::status() {
  const auto speed = client_.latest<can::SpeedStatus>();
  if (!speed) return tl::unexpected(speed.error());
  const auto move = client_.move_progress();
  if (!move) return tl::unexpected(move.error());
  const Mode mode = [this] {
    const std::lock_guard lock(mutex_);
    const bool gone = mode_ == Mode::Goal && client_.generation() != goal_generation_;
    return gone ? Mode::Failed : mode_;
  }();
  DriveStatus status;
  status.stalled_left = speed->stall_left;
  status.stalled_right = speed->stall_right;
  if (mode == Mode::Failed || (mode == Mode::Goal && *move == bridges::MoveProgress::Failed)) {
    status.progress = DriveProgress::Failed;
  } else if (mode == Mode::Goal && *move != bridges::MoveProgress::Done) {
    status.progress = DriveProgress::Driving;
    status.remaining = std::abs(mm_to_m(speed->remaining_mm));
  }
  return status;
}

Result<Twist> CanDrive::measured_twist() {
  return client_.latest<can::SpeedStatus>().map([](const can::SpeedStatus& speed) {
    return Twist{mm_to_m(speed.v_mm_s), from_centi_degrees(speed.w_cdeg_s)};
  });
}

Result<Pose> CanDrive::odometry() {
  // Not the one that it began with.
  if (client_.restarts() != restored_) {
    return fail(Errc::Disconnected, "the robot has restarted: it is being told where it was");
  }
  return told_pose();
}

Result<Pose> CanDrive::told_pose() const {
  return client_.latest<can::PoseStatus>().map([](const can::PoseStatus& pose) {
    return Pose{mm_to_m(pose.x_mm), mm_to_m(pose.y_mm),
                wrap_angle(from_centi_degrees(pose.phi_cdeg))};
  });
}

Result<void> CanDrive::set_odometry(const Pose& pose) {
  const auto mm = [](double metres) {
    return static_cast<std::int32_t>(std::lround(std::clamp(m_to_mm(metres), -1e9, 1e9)));
  };
  return client_.set_pose({mm(pose.x), mm(pose.y), to_centi_degrees(pose.theta)});
}

}  // namespace eyebridge::hal
