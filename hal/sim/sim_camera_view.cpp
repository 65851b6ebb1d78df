#include "sim/sim_camera_view.hpp"

#include "eyebridge/base/math.hpp"

namespace eyebridge::hal {
namespace {

/// Angle of a servo at `position` 0 … 1 whose throw to either side is `max_angle`.
double servo_angle(double position, double max_angle) { return (2 * position - 1) * max_angle; }

}  // namespace

world::Scene SimCameraView::scene() const {
  return world_.locked([](auto& sim) { return sim.world().scene(sim.time()); });
}

camera::Eye SimCameraView::eye() const {
  return world_.locked([&](auto& sim) {
    const robot::CameraModel& model = *sim.model(robot_).camera;
    const Pose camera_in_robot{model.x, model.y,
                               model.pan + servo_angle(sim.servo(robot_, 0), model.max_pan)};
    const Pose camera_in_world = transform(sim.pose(robot_), camera_in_robot);
    camera::Eye eye;
    eye.x = camera_in_world.x;
    eye.y = camera_in_world.y;
    eye.z = model.z;
    eye.heading = camera_in_world.theta;
    eye.pitch = model.tilt + servo_angle(sim.servo(robot_, 1), model.max_tilt);
    eye.horizontal_field_of_view = model.horizontal_field_of_view;
    return eye;
  });
}

std::uint32_t SimCameraView::carrier() const {
  return world_.locked([&](auto& sim) { return sim.body(robot_); });
}

camera::ImageNoise SimCameraView::noise() const {
  const robot::CameraModel& model = *world_.model(robot_).camera;
  return {model.salt_and_pepper, model.sigma,
          world_.locked([&](auto& sim) { return sim.camera_noise_seed(robot_); })};
}

std::string SimCameraView::texture_directory() const { return world_.directory(); }

}  // namespace eyebridge::hal
