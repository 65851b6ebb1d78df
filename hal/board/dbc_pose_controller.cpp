#include "board/dbc_pose_controller.hpp"

#include "board/dbc_link.hpp"
#include "eyebridge/base/math.hpp"

namespace eyebridge::hal {
namespace {

/// The frame in which `local` is `pose`.
Pose frame_of(const Pose& pose, const Pose& local) {
  const Pose back = relative_to(local, Pose{});
  Pose frame = transform(pose, back);
  frame.theta = wrap_angle(frame.theta);
  return frame;
}

}  // namespace

DbcPoseController::DbcPoseController(DbcLink& link, Clock& clock, const BoardDriveShape& shape)
    : link_(link), host_(link, clock, shape) {
  // A program begins at 0, wherever the robot has been before.
  (void)set_odometry(Pose{});
}

Result<Pose> DbcPoseController::odometry() {
  return link_.pose().map([this](const Pose& own) {
    const std::lock_guard lock(mutex_);
    if (is_moved_ && last_) origin_ = frame_of(*last_, own);
    is_moved_ = false;
    Pose pose = transform(origin_, own);
    pose.theta = wrap_angle(pose.theta);
    last_ = pose;
    return pose;
  });
}

Result<void> DbcPoseController::set_odometry(const Pose& pose) {
  return link_.pose().map([&](const Pose& own) {
    const std::lock_guard lock(mutex_);
    origin_ = frame_of(pose, own);
    is_moved_ = false;
    last_ = pose;
  });
}

void DbcPoseController::restarted() {
  {
    const std::lock_guard lock(mutex_);
    is_moved_ = true;
  }
  host_.restarted();
}

}  // namespace eyebridge::hal
