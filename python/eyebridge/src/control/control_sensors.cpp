#include "control_sensors.hpp"

#include <numbers>
#include <tuple>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "likelihood.hpp"

namespace eyebridge::python {
namespace {

namespace py = pybind11;

/// Kind, number, name, where it sits in the robot, and how far it reaches (0: not by distance).
using SensorRow = std::tuple<std::string, int, std::string, py::tuple, double>;

std::vector<SensorRow> sensors(ControlWorld& world, std::size_t index) {
  const robot::RobotModel& model = world.model(index);
  hal::Backend& robot = world.robot(index);
  std::vector<SensorRow> rows;
  const auto add = [&](const char* kind, int id, const std::string& name, const Pose& pose,
                       double reach) { rows.emplace_back(kind, id, name, as_tuple(pose), reach); };
  for (const auto& psd : model.range_sensors) {
    add("psd", psd.id, psd.name, psd.pose_in_robot, psd.max_range);
  }
  for (const auto& ir : model.proximity_sensors) {
    add("ir", ir.id, ir.name, ir.pose_in_robot, ir.threshold);
  }
  for (const auto& bumper : model.bumpers) add("bumper", bumper.id, bumper.name, {}, 0);
  if (model.lidar) add("lidar", 1, "lidar", model.lidar->pose_in_robot, model.lidar->max_range);
  if (robot.compass() != nullptr) add("compass", 1, "compass", {}, 0);
  if (robot.gyroscope() != nullptr) add("gyroscope", 1, "gyroscope", {}, 0);
  if (robot.accelerometer() != nullptr) add("accelerometer", 1, "accelerometer", {}, 0);
  for (const auto& [name, id] : encoders(world, index)) {
    add("encoder", id, "encoder " + name, {}, 0);
  }
  return rows;
}

py::array_t<double> read_lidar(hal::Lidar& lidar) {
  py::array_t<double> ranges(lidar.points());
  need(lidar.read({ranges.mutable_data(), static_cast<std::size_t>(ranges.size())}));
  return ranges;
}

/// Forward, left.
py::array_t<double> read_accelerometer(hal::Accelerometer& accelerometer) {
  const Vec2 felt = need(accelerometer.read());
  py::array_t<double> axes(2);
  axes.mutable_at(0) = felt.x;
  axes.mutable_at(1) = felt.y;
  return axes;
}

py::object read_sensor(ControlWorld& world, std::size_t index, const std::string& kind, int id) {
  hal::Backend& robot = world.robot(index);
  if (kind == "psd") return py::cast(need(need(robot.range_sensor(id), "psd", id).read()));
  if (kind == "ir") return py::cast(need(need(robot.proximity(id), "ir", id).read()));
  if (kind == "bumper") return py::cast(need(need(robot.bumper(id), "bumper", id).read()));
  if (kind == "compass") return py::cast(need(need(robot.compass(), "compass", 1).read()));
  if (kind == "gyroscope") return py::cast(need(need(robot.gyroscope(), "gyroscope", 1).read()));
  if (kind == "encoder") return py::cast(need(need(robot.encoder(id), "encoder", id).read()));
  if (kind == "lidar") return read_lidar(need(robot.lidar(), "lidar", 1));
  if (kind != "accelerometer") throw std::out_of_range("sensor " + kind);
  return read_accelerometer(need(robot.accelerometer(), "accelerometer", 1));
}

/// The one of `models` that has this number.
template <class Model>
const Model& with_id(const std::vector<Model>& models, const char* kind, int id) {
  for (const Model& model : models) {
    if (model.id == id) return model;
  }
  throw std::out_of_range(std::string(kind) + " " + std::to_string(id));
}

/// P(reading | truth), by the errors that the robot has now.
py::object probability(ControlWorld& world, std::size_t index, const std::string& kind, int id,
                       const Numbers& reading, const Numbers& truth, double resolution,
                       double elapsed) {
  world.refresh(index);
  const robot::RobotModel& model = world.model(index);
  if (kind == "psd") {
    const robot::RangeSensorModel& psd = with_id(model.range_sensors, "psd", id);
    return probabilities(reading, truth, resolution,
                         [&](double distance) { return robot::RangeReadings(psd, distance); });
  }
  if (kind == "ir") {
    return probabilities_of_switch(with_id(model.proximity_sensors, "ir", id).error, reading,
                                   truth);
  }
  if (kind == "bumper") {
    return probabilities_of_switch(with_id(model.bumpers, "bumper", id).error, reading, truth);
  }
  if (kind == "lidar") return lidar_probabilities(model, reading, truth, resolution);
  if (kind == "compass") return compass_probabilities(model, reading, truth, resolution);
  if (kind == "gyroscope") {
    return gyroscope_probabilities(model, reading, truth, resolution, elapsed);
  }
  if (kind == "encoder") return encoder_probabilities(model, reading, truth, resolution);
  if (kind != "accelerometer") throw std::out_of_range("sensor " + kind);
  return accelerometer_probabilities(model, reading, truth, resolution);
}

/// Bearings of the rays of a scan in the robot, as they come: from the left-most one, clockwise.
py::array_t<double> lidar_bearings(ControlWorld& world, std::size_t index) {
  const hal::LidarShape shape = need(world.robot(index).lidar(), "lidar", 1).shape();
  py::array_t<double> bearings(shape.points);
  const double first = shape.points == 1 ? 0.0 : shape.field_of_view / 2;
  // A full circle does not show its first ray again.
  const bool is_circle = shape.field_of_view >= 2 * std::numbers::pi - 1e-9;
  const double gap =
      shape.points == 1 ? 0.0 : shape.field_of_view / (is_circle ? shape.points : shape.points - 1);
  for (int i = 0; i < shape.points; ++i) bearings.mutable_at(i) = first - i * gap;
  return bearings;
}

Wheels numbered(const std::vector<robot::DrivePart>& parts) {
  Wheels wheels;
  for (const auto& part : parts) {
    wheels.emplace_back(part.name, static_cast<int>(wheels.size()) + 1);
  }
  return wheels;
}

}  // namespace

Wheels motors(const ControlWorld& world, std::size_t index) {
  return numbered(facts_of(world.model(index).drive.kind).motors);
}

Wheels encoders(const ControlWorld& world, std::size_t index) {
  return numbered(facts_of(world.model(index).drive.kind).encoders);
}

void bind_control_sensors(py::class_<ControlWorld>& world) {
  world.def("sensors", &sensors)
      .def("read", &read_sensor)
      .def("probability", &probability)
      .def("lidar_bearings", &lidar_bearings)
      .def("field_of_view", [](ControlWorld& self, std::size_t index) {
        return need(self.robot(index).lidar(), "lidar", 1).shape().field_of_view;
      });
}

}  // namespace eyebridge::python
