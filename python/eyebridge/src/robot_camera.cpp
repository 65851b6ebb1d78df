#include "robot_camera.hpp"

#include <stdexcept>
#include <utility>

#include "eyebridge/camera/robot_eye.hpp"
#include "eyebridge/camera/view.hpp"

namespace eyebridge::python {

class RobotCamera::View final : public camera::View {
 public:
  View(std::shared_ptr<SharedSimulation> simulation, robot::RobotIndex robot)
      : simulation_(std::move(simulation)), robot_(robot) {
    if (!simulation_->with([&](const auto& sim) { return sim.model(robot).camera.has_value(); })) {
      throw std::invalid_argument("this robot has no camera");
    }
  }

  [[nodiscard]] world::Scene scene() const override {
    return simulation_->with([](const auto& sim) { return sim.world().scene(sim.time()); });
  }
  [[nodiscard]] camera::Eye eye() const override {
    return simulation_->with([&](const auto& sim) { return camera::eye_of(sim, robot_); });
  }
  [[nodiscard]] std::uint32_t carrier() const override {
    return simulation_->with([&](const auto& sim) { return sim.body(robot_); });
  }
  [[nodiscard]] camera::ImageNoise noise() const override {
    return simulation_->with([&](const auto& sim) { return camera::noise_of(sim, robot_); });
  }
  [[nodiscard]] std::string texture_directory() const override {
    return simulation_->scenario().directory.string();
  }

 private:
  const std::shared_ptr<SharedSimulation> simulation_;
  const robot::RobotIndex robot_;
};

RobotCamera::RobotCamera(std::shared_ptr<SharedSimulation> simulation, robot::RobotIndex robot,
                         int width, int height, std::string url)
    : simulation_(std::move(simulation)),
      view_(std::make_unique<View>(simulation_, robot)),
      width_(width),
      height_(height),
      url_(std::move(url)) {
  open();
}

RobotCamera::~RobotCamera() = default;

void RobotCamera::open() {
  source_.reset();
  generation_ = simulation_->generation();
  clock_ = std::make_unique<JumpingClock>();
  source_ = camera::open_source(url_, {clock_.get(), view_.get(), nullptr});
  if (const Result<void> sized = source_->set_size(width_, height_); !sized) {
    throw std::invalid_argument(sized.error().what);
  }
}

camera::FramePtr RobotCamera::frame() {
  const std::lock_guard lock(mutex_);
  if (generation_ != simulation_->generation()) open();
  const Result<camera::FramePtr> frame = source_->next(clock_->now() + std::chrono::seconds(1));
  if (!frame) throw std::runtime_error(frame.error().what);
  return *frame;
}

}  // namespace eyebridge::python
