#include "hand/hand_backend.hpp"

#include <optional>
#include <utility>

#include "eyebridge/camera/view.hpp"
#include "eyebridge/hal/passing_backend.hpp"
#include "hand/hand_drive.hpp"
#include "hand/pulling_clock.hpp"
#include "mix/follow.hpp"

namespace eyebridge::hal {
namespace {

/// Where the camera sits on the robot now.
Pose camera_in_robot(Backend& backend) {
  const camera::Eye eye = backend.camera_view()->eye();
  return relative_to(backend.world()->robot_pose(0).value(), {eye.x, eye.y, eye.heading});
}

class HandBackend final : public PassingBackend {
 public:
  HandBackend(std::unique_ptr<Backend> inner, HandParts parts)
      : PassingBackend(nullptr),
        world_(*inner->world()),
        display_(std::move(parts.display)),
        robot_({std::move(parts.finder), camera_in_robot(*inner), inner->clock(),
                [this](const Pose& pose) { (void)world_.set_robot_pose(0, pose); }, *display_}),
        inner_clock_(inner->clock()),
        camera_(std::move(parts.camera), inner_clock_, robot_),
        pulling_(inner_clock_, camera_),
        drive_(robot_, clock()) {
    tracker_.follow([this] { return wait_for_pose(robot_, clock()); });
    inner_ = make_following(std::move(inner), {nullptr, &world_, &tracker_, false});
  }

  Clock& clock() override {
    if (inner_clock_.is_virtual()) return pulling_;
    return inner_clock_;
  }
  Device* find(DeviceKind kind, int id) override {
    if (kind == DeviceKind::Drive) return &drive_;
    const bool is_of_wheel = kind == DeviceKind::Motor || kind == DeviceKind::Encoder;
    return is_of_wheel ? nullptr : inner_->find(kind, id);
  }
  camera::Source* camera_source() override { return &camera_; }
  HandGuide* hand_guide() override { return &robot_; }
  Result<void> stop() noexcept override {
    try {
      robot_.set_speed({});
      display_->finish();
    } catch (...) {
      // A display that has no memory left: there is no motor that could run on.
    }
    return inner_->stop();
  }

 private:
  WorldControl& world_;
  std::unique_ptr<InstructionSink> display_;
  CarriedRobot robot_;
  Clock& inner_clock_;
  PoseTracker tracker_;
  camera::SharedSource camera_;  ///< Calls the robot from a thread of its own: ends before it.
  PullingClock pulling_;
  HandDrive drive_;
};

}  // namespace

std::unique_ptr<Backend> make_hand(std::unique_ptr<Backend> inner, HandParts parts) {
  return std::make_unique<HandBackend>(std::move(inner), std::move(parts));
}

}  // namespace eyebridge::hal
