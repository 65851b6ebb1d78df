#pragma once

#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <pybind11/pybind11.h>

#include "control_world.hpp"

namespace eyebridge::python {

/// The value, or RuntimeError with what the device said.
template <class T>
T need(const Result<T>& result) {
  if (!result) throw std::runtime_error(result.error().what);
  if constexpr (!std::is_void_v<T>) return *result;
}

/// A device that is there: routines ask by the names of sensors().
template <class Device>
Device& need(Device* device, const char* kind, int id) {
  if (device == nullptr) throw std::out_of_range(std::string(kind) + " " + std::to_string(id));
  return *device;
}

inline pybind11::tuple as_tuple(const Pose& pose) {
  return pybind11::make_tuple(pose.x, pose.y, pose.theta);
}

/// Names of wheels, and their numbers from 1.
using Wheels = std::vector<std::pair<std::string, int>>;

/// What docs/drives.md calls the motors of this robot's kind of drive.
Wheels motors(const ControlWorld& world, std::size_t index);
/// Those wheels that have encoders: a car's are at its rear wheels.
Wheels encoders(const ControlWorld& world, std::size_t index);

/// What sensors a robot has, what they say, and how likely that is.
void bind_control_sensors(pybind11::class_<ControlWorld>& world);

}  // namespace eyebridge::python
