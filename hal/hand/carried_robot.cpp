#include "hand/carried_robot.hpp"

#include <utility>

#include <fmt/format.h>

namespace eyebridge::hal {
namespace {

// Long enough that a few millimetres of noise are no speed, short enough to follow a hand.
constexpr Time kSpeedWindow = std::chrono::milliseconds(250);

/// Of the robot's pose, by that of the camera, from which the robot is `offset` away: an uncertain
/// heading swings that offset.
std::array<double, 9> covariance_of(const camera::FoundPose& camera, const Pose& offset) {
  const Vec2 way = Heading::from_angle(camera.pose.theta).rotate(offset.position());
  const double jacobian[3][3] = {{1.0, 0.0, -way.y}, {0.0, 1.0, way.x}, {0.0, 0.0, 1.0}};
  std::array<double, 9> covariance{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t l = 0; l < 3; ++l) {
          covariance[3 * i + j] += jacobian[i][k] * camera.covariance[3 * k + l] * jacobian[j][l];
        }
      }
    }
  }
  return covariance;
}

}  // namespace

CarriedRobot::CarriedRobot(Parts parts)
    : finder_(std::move(parts.finder)),
      robot_in_camera_(relative_to(parts.camera_in_robot, {})),
      clock_(parts.clock),
      moved_(std::move(parts.moved)),
      display_(parts.display) {}

void CarriedRobot::frame(const camera::FramePtr& frame) {
  take(frame, finder_->take(*frame));
  show();
}

void CarriedRobot::no_frame(const Error& why) {
  {
    const std::lock_guard lock(mutex_);
    no_frame_ = why;
  }
  show();
}

void CarriedRobot::take(const camera::FramePtr& frame,
                        const std::optional<camera::FoundPose>& found) {
  std::optional<Pose> pose;
  {
    const std::lock_guard lock(mutex_);
    no_frame_.reset();
    last_frame_ = clock_.now();
    frame_ = frame;
    markers_.clear();
    for (const camera::SeenFiducial& seen : finder_->seen()) {
      markers_.push_back({seen.id, seen.corners});
    }
    if (!found) return seen_.clear();
    pose = transform(found->pose, robot_in_camera_);
    if (last_) movement_.moved(*last_, *pose);
    if (!odometry_in_world_) odometry_in_world_ = pose;
    last_ = pose;
    last_seen_ = found->time;
    covariance_ = covariance_of(*found, robot_in_camera_);
    seen_.push_back({found->time, *pose});
    while (seen_.size() > 2 && found->time - seen_[1].time >= kSpeedWindow) seen_.pop_front();
  }
  moved_(*pose);
}

void CarriedRobot::show() {
  Instruction instruction;
  {
    const std::lock_guard lock(mutex_);
    instruction = instruction_now();
  }
  display_.show(clock_.now(), instruction);
}

HandLook CarriedRobot::look() const {
  const std::lock_guard lock(mutex_);
  HandLook look;
  look.instruction = instruction_now();
  look.has_markers = true;
  if (const Result<Pose> pose = pose_now()) look.pose = *pose;
  look.covariance = covariance_;
  look.frame = frame_;
  look.markers = markers_;
  return look;
}

Instruction CarriedRobot::instruction_now() const {
  Instruction instruction = movement_.instruction();
  if (!pose_now()) {
    instruction.kind = Instruction::Kind::Lost;
    instruction.reason = why_lost().what;
  }
  return instruction;
}

Result<Pose> CarriedRobot::pose_now() const {
  if (!seen_.empty() && clock_.now() - last_seen_ <= kFresh) return seen_.back().pose;
  return tl::unexpected(why_lost());
}

Error CarriedRobot::why_lost() const {
  const bool silent = !last_frame_ || clock_.now() - *last_frame_ > kFresh;
  // A pause between two frames is no news; a camera that is gone is.
  if (no_frame_ && (silent || no_frame_->code != Errc::Timeout)) return *no_frame_;
  if (!last_) return {Errc::Timeout, "the camera has seen no marker yet"};
  return {Errc::Timeout, fmt::format("the camera has seen no marker since {:.1f} s on its clock",
                                     to_seconds(last_seen_))};
}

Result<Pose> CarriedRobot::pose() const {
  const std::lock_guard lock(mutex_);
  return pose_now();
}

Time CarriedRobot::last_seen() const {
  const std::lock_guard lock(mutex_);
  return last_seen_;
}

Result<Pose> CarriedRobot::odometry() const {
  const std::lock_guard lock(mutex_);
  return pose_now().map([&](const Pose& pose) {
    return transform(odometry_, relative_to(odometry_in_world_.value(), pose));
  });
}

Result<Twist> CarriedRobot::twist() const {
  const std::lock_guard lock(mutex_);
  return pose_now().and_then([&](const Pose& pose) -> Result<Twist> {
    const Seen& first = seen_.front();
    const double seconds = to_seconds(seen_.back().time - first.time);
    if (seconds <= 0.0) return fail(Errc::Timeout, "drive: one pose so far, no speed");
    const Pose way = relative_to(first.pose, pose);
    const Vec2 forward = Heading::from_angle(0.5 * way.theta).forward();
    return Twist{dot(way.position(), forward) / seconds, way.theta / seconds};
  });
}

Result<DriveStatus> CarriedRobot::status() const {
  const std::lock_guard lock(mutex_);
  return pose_now().map([&](const Pose&) {
    // A person is never stalled.
    return DriveStatus{movement_.driving() ? DriveProgress::Driving : DriveProgress::Done,
                       movement_.remaining(), false, false};
  });
}

Result<void> CarriedRobot::start(const DriveGoal& goal) {
  {
    const std::lock_guard lock(mutex_);
    const Result<Pose> here = pose_now();
    if (!here) return tl::unexpected(here.error());
    movement_.start(goal, *here);
  }
  show();
  return {};
}

Result<void> CarriedRobot::set_odometry(const Pose& pose) {
  const std::lock_guard lock(mutex_);
  return pose_now().map([&](const Pose& here) {
    odometry_in_world_ = here;
    odometry_ = pose;
  });
}

void CarriedRobot::set_speed(const Twist& twist) {
  {
    const std::lock_guard lock(mutex_);
    movement_.set_speed(twist);
  }
  show();
}

}  // namespace eyebridge::hal
