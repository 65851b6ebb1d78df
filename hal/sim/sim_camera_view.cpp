#include "sim/sim_camera_view.hpp"

#include "eyebridge/camera/robot_eye.hpp"

namespace eyebridge::hal {

world::Scene SimCameraView::scene() const {
  return world_.locked([](auto& sim) { return sim.world().scene(sim.time()); });
}

camera::Eye SimCameraView::eye() const {
  return world_.sensed([&](auto& sim) { return camera::eye_of(sim, robot_); });
}

std::uint32_t SimCameraView::carrier() const {
  return world_.locked([&](auto& sim) { return sim.body(robot_); });
}

camera::ImageNoise SimCameraView::noise() const {
  return world_.sensed([&](auto& sim) { return camera::noise_of(sim, robot_); });
}

std::string SimCameraView::texture_directory() const { return world_.directory(); }

}  // namespace eyebridge::hal
