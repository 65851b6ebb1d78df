#pragma once

#include "eyebridge/camera/source.hpp"
#include "eyebridge/camera/view.hpp"
#include "hand/hand_backend.hpp"
#include "hand_person.hpp"
#include "rigs.hpp"

namespace eyebridge::hal {

/// A robot in the room of the rigs that a scripted person carries.
struct HandRig {
  std::shared_ptr<Hand> hand = std::make_shared<Hand>();
  std::shared_ptr<std::optional<Error>> trouble = std::make_shared<std::optional<Error>>();
  Rig rig;
  Backend* simulated = nullptr;
  std::unique_ptr<Backend> robot;

  explicit HandRig(Rig inner = lockstep_rig(facing(1.0))) : rig(std::move(inner)) {
    simulated = rig.backend.get();
    const Pose start = simulated->world()->robot_pose(0).value();
    const camera::Eye eye = simulated->camera_view()->eye();
    hand->robot = start;
    hand->camera_in_robot = relative_to(start, {eye.x, eye.y, eye.heading});
    HandParts parts;
    parts.camera = std::make_unique<PlainCamera>(simulated->clock(), trouble);
    parts.finder = std::make_unique<PersonFinder>(hand);
    parts.display = std::make_unique<HandEye>(hand);
    robot = make_hand(std::move(rig.backend), std::move(parts));
  }

  void wait(double seconds) const {
    robot->clock().wait_until(robot->clock().now() + from_seconds(seconds));
  }
  /// As VWWait: until the movement is made, at most two minutes.
  [[nodiscard]] Result<DriveStatus> wait_for_drive() const {
    const Time end = robot->clock().now() + std::chrono::minutes(2);
    for (;;) {
      Result<DriveStatus> status = robot->drive()->status();
      if (!status || status->progress != DriveProgress::Driving || robot->clock().now() > end) {
        return status;
      }
      wait(0.01);
    }
  }
  void put(const Pose& pose) const {
    const std::lock_guard lock(hand->mutex);
    hand->robot = pose;
  }
  [[nodiscard]] Pose place() const {
    const std::lock_guard lock(hand->mutex);
    return hand->robot;
  }
  [[nodiscard]] Instruction told() const {
    const std::lock_guard lock(hand->mutex);
    return hand->told;
  }
};

}  // namespace eyebridge::hal
