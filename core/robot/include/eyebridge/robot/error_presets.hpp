#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include "eyebridge/robot/robot_model.hpp"

namespace eyebridge::robot {

/// One error model of each kind: what all devices of a robot suffer that are of that kind.
struct ErrorModels {
  DriveError drive;
  RangeError range;
  ProximityError proximity;
  BumperError bumper;
  LidarError lidar;
  RangeMatrixError range_matrix;
  CompassError compass;
  CameraError camera;
  RadioError radio;
  GyroscopeError gyroscope;
  AccelerometerError accelerometer;

  friend bool operator==(const ErrorModels&, const ErrorModels&) = default;
};

/// All members of `models`, each of a type of its own.
inline auto parts_of(ErrorModels& models) {
  return std::tie(models.drive, models.range, models.proximity, models.bumper, models.lidar,
                  models.range_matrix, models.compass, models.camera, models.radio,
                  models.gyroscope, models.accelerometer);
}
/// The place of `Error` among them.
template <class Error>
inline constexpr std::size_t kErrorPart =
    []<class... Parts>(std::type_identity<std::tuple<Parts&...>>) {
      constexpr std::array<bool, sizeof...(Parts)> kIs{std::is_same_v<Parts, Error>...};
      return static_cast<std::size_t>(std::ranges::find(kIs, true) - kIs.begin());
    }(std::type_identity<decltype(parts_of(std::declval<ErrorModels&>()))>{});

/// The member of `models` that is an `Error`.
template <class Error>
Error& part_of(ErrorModels& models) {
  return std::get<Error&>(parts_of(models));
}

/// Calls `visit(error, id)` for the error model of each device of `model`, a RobotModel that may be
/// const; `id` is the device's, 0 where a robot has one of the kind only.
template <class Model, class Visit>
void for_each_error(Model& model, Visit&& visit) {
  visit(model.drive_error, 0);
  for (auto& sensor : model.range_sensors) visit(sensor.error, sensor.id);
  for (auto& sensor : model.proximity_sensors) visit(sensor.error, sensor.id);
  for (auto& bumper : model.bumpers) visit(bumper.error, bumper.id);
  if (model.lidar) visit(model.lidar->error, 0);
  for (auto& matrix : model.range_matrices) visit(matrix.error, matrix.id);
  visit(model.compass_error, 0);
  if (model.camera) visit(model.camera->error, 0);
  visit(model.radio_error, 0);
  visit(model.gyroscope_error, 0);
  visit(model.accelerometer_error, 0);
}

/// The names of the presets, from none to most.
inline constexpr std::array<std::string_view, 3> kErrorPresets = {"perfect", "realistic", "harsh"};

/// The preset of that name, case as written; nothing when there is none. "perfect" is no error at
/// all, "realistic" what a well kept robot in a lab shows, "harsh" about four times that.
std::optional<ErrorModels> error_preset(std::string_view name);

/// Gives all devices of `model` the errors of `errors`, whatever they had.
void set_errors(RobotModel& model, const ErrorModels& errors);

/// Scales all errors of `model` by `share`, 0 (perfect) … 1 (as they are).
void scale_errors(RobotModel& model, double share);

/// Gives the devices of `to` the errors that those of `from` have. Throws std::invalid_argument
/// when the two do not have the same numbers of devices.
void copy_errors(const RobotModel& from, RobotModel& to);

/// True when no device of `model` has an error.
bool is_perfect(const RobotModel& model);

}  // namespace eyebridge::robot
