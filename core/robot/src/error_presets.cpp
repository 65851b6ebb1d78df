#include "eyebridge/robot/error_presets.hpp"

#include <algorithm>
#include <stdexcept>

namespace eyebridge::robot {
namespace {

// Orders of magnitude, not measurements of one robot: a Sharp PSD repeats to about 1 % and a few
// millimetres, a small scanner to 5 mm and 1 %, a compass among motors to 2 degrees, wheels differ
// by some tenths of a per cent (Borenstein and Feng 1996 saw that much), a webcam has a sigma of 2
// to 4 grey levels; a cheap MEMS gyroscope is noisy to 0.1 degree per second and strays by a
// hundredth in a second, an accelerometer to some hundredths of a metre per second squared.
// docs/errors.md has them as a table.
ErrorModels realistic() {
  ErrorModels errors;
  errors.drive.linear_sigma = 0.02;
  errors.drive.angular_sigma = 0.02;
  errors.drive.left_scale = 0.003;
  errors.drive.right_scale = -0.003;
  errors.drive.encoder_quantised = true;
  errors.drive.slip = 0.002;
  errors.range.sigma = 0.003;
  errors.range.sigma_relative = 0.01;
  errors.range.dropout = 0.002;
  errors.range.quantised = true;
  errors.proximity.flip = 0.005;
  errors.bumper.miss = 0.01;
  errors.lidar.sigma = 0.005;
  errors.lidar.sigma_relative = 0.01;
  errors.lidar.dropout = 0.005;
  errors.range_matrix = {{{0.0, 0.005, 0.02}, 0.01}};
  errors.compass.sigma = deg_to_rad(2);
  errors.camera.salt_and_pepper = 0.0005;
  errors.camera.sigma = 3;
  errors.camera.blur = 0.5;
  errors.camera.exposure_sigma = 0.03;
  errors.radio = {0.02, 0.02, 0.01, 0.001, 30};
  errors.range.cross_talk = 0.01;
  errors.gyroscope.sigma = deg_to_rad(0.1);
  errors.gyroscope.drift = deg_to_rad(0.01);
  errors.accelerometer.sigma = 0.05;
  return errors;
}

ErrorModels harsh() {
  ErrorModels errors;
  errors.drive.linear_sigma = 0.08;
  errors.drive.angular_sigma = 0.08;
  errors.drive.left_scale = 0.012;
  errors.drive.right_scale = -0.012;
  errors.drive.encoder_quantised = true;
  errors.drive.slip = 0.01;
  errors.drive.encoder_miss = 0.005;
  errors.range.sigma = 0.012;
  errors.range.sigma_relative = 0.04;
  errors.range.dropout = 0.02;
  errors.range.quantised = true;
  errors.proximity.flip = 0.02;
  errors.bumper.miss = 0.05;
  errors.lidar.sigma = 0.02;
  errors.lidar.sigma_relative = 0.03;
  errors.lidar.dropout = 0.03;
  errors.range_matrix = {{{0.0, 0.02, 0.08}, 0.04}};
  errors.compass.bias = deg_to_rad(4);
  errors.compass.sigma = deg_to_rad(8);
  errors.camera = {0.005, 12, 0.005, 1.5, -0.5, 0.15};
  errors.radio = {0.1, 0.1, 0.05, 0.01, 5};
  errors.range.cross_talk = 0.05;
  errors.gyroscope.bias = deg_to_rad(1);
  errors.gyroscope.sigma = deg_to_rad(0.5);
  errors.gyroscope.drift = deg_to_rad(0.05);
  errors.accelerometer.bias = 0.2;
  errors.accelerometer.sigma = 0.2;
  return errors;
}

}  // namespace

std::optional<ErrorModels> error_preset(std::string_view name) {
  if (name == "perfect") return ErrorModels{};
  if (name == "realistic") return realistic();
  if (name == "harsh") return harsh();
  return std::nullopt;
}

void set_errors(RobotModel& model, const ErrorModels& errors) {
  ErrorModels copy = errors;
  for_each_error(model, [&](auto& error, int) {
    error = part_of<std::remove_reference_t<decltype(error)>>(copy);
  });
}

void scale_errors(RobotModel& model, double share) {
  for_each_error(model, [&](auto& error, int) { error = error.scaled(share); });
}

void copy_errors(const RobotModel& from, RobotModel& to) {
  if (from.range_sensors.size() != to.range_sensors.size() ||
      from.proximity_sensors.size() != to.proximity_sensors.size() ||
      from.bumpers.size() != to.bumpers.size() || from.lidar.has_value() != to.lidar.has_value() ||
      from.range_matrices.size() != to.range_matrices.size() ||
      from.camera.has_value() != to.camera.has_value()) {
    throw std::invalid_argument("errors: expected those of a robot with the same devices");
  }
  const auto copy = [](const auto& given, auto& taken) {
    for (std::size_t i = 0; i < given.size(); ++i) taken[i].error = given[i].error;
  };
  to.drive_error = from.drive_error;
  copy(from.range_sensors, to.range_sensors);
  copy(from.proximity_sensors, to.proximity_sensors);
  copy(from.bumpers, to.bumpers);
  if (from.lidar) to.lidar->error = from.lidar->error;
  copy(from.range_matrices, to.range_matrices);
  to.compass_error = from.compass_error;
  if (from.camera) to.camera->error = from.camera->error;
  to.radio_error = from.radio_error;
  to.gyroscope_error = from.gyroscope_error;
  to.accelerometer_error = from.accelerometer_error;
}

bool is_perfect(const RobotModel& model) {
  bool perfect = true;
  for_each_error(model, [&](const auto& error, int) { perfect = perfect && error.perfect(); });
  return perfect;
}

}  // namespace eyebridge::robot
