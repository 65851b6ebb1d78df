#pragma once

#include "eyebridge/base/pose.hpp"
#include "eyebridge/camera/view.hpp"
#include "eyebridge/robot/simulation.hpp"

namespace eyebridge::camera {

/// Where the camera of a simulated robot is now, pan and tilt included. The robot has one; who asks
/// links eyebridge::robot. A servo that steers a car turns no camera: that one stays in its middle.
/// As thread-safe as the simulation.
inline Eye eye_of(const robot::Simulation& sim, robot::RobotIndex robot) {
  // Of a servo at 0 … 1 whose throw to either side is `most`, radians.
  const auto angle = [&](unsigned servo, double most) {
    return sim.model(robot).drive.steers(servo) ? 0.0 : (2 * sim.servo(robot, servo) - 1) * most;
  };
  const robot::CameraModel& model = *sim.model(robot).camera;
  const Pose camera_in_robot{model.x, model.y, model.pan + angle(0, model.max_pan)};
  const Pose camera_in_world = transform(sim.pose(robot), camera_in_robot);
  Eye eye;
  eye.x = camera_in_world.x;
  eye.y = camera_in_world.y;
  eye.z = sim.altitude(robot) + model.z;
  eye.heading = camera_in_world.theta;
  eye.pitch = model.tilt + angle(1, model.max_tilt);
  eye.horizontal_field_of_view = model.horizontal_field_of_view;
  return eye;
}

/// What its pictures suffer from; otherwise as eye_of().
inline ImageNoise noise_of(const robot::Simulation& sim, robot::RobotIndex robot) {
  const robot::CameraModel& model = *sim.model(robot).camera;
  return {model.error, sim.camera_noise_seed(robot)};
}

}  // namespace eyebridge::camera
