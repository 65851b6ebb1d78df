// Robot.*_probability(): how likely readings are, for numpy arrays of them.
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include <pybind11/stl.h>

#include "bindings.hpp"
#include "likelihood.hpp"
#include "robot_handle.hpp"

namespace eyebridge::python {
namespace {

namespace py = pybind11;

robot::RobotModel model_of(const RobotHandle& robot) {
  const py::gil_scoped_release others_run;
  return robot.simulation->with([&](auto& sim) { return sim.model(robot.index); });
}

py::object of_psd(const RobotHandle& robot, int id, const Numbers& reading, const Numbers& distance,
                  double resolution, std::optional<int> cross_talkers) {
  if (cross_talkers && *cross_talkers < 0) refuse("cross_talkers", *cross_talkers, "0 or more");
  const auto [sensor, talkers] = [&] {
    const py::gil_scoped_release others_run;
    return robot.simulation->with([&](auto& sim) {
      const auto& sensors = sim.model(robot.index).range_sensors;
      for (std::size_t i = 0; i < sensors.size(); ++i) {
        if (sensors[i].id != id) continue;
        const unsigned count = cross_talkers ? static_cast<unsigned>(*cross_talkers)
                                             : sim.cross_talkers(robot.index, i);
        return std::pair(sensors[i], count);
      }
      throw std::out_of_range("this robot has no PSD " + std::to_string(id));
    });
  }();
  return probabilities(reading, distance, resolution,
                       [&sensor = sensor, talkers = talkers](double truth) {
                         return robot::RangeReadings(sensor, truth, talkers);
                       });
}

py::object of_lidar(const RobotHandle& robot, const Numbers& reading, const Numbers& distance,
                    double resolution) {
  return lidar_probabilities(model_of(robot), reading, distance, resolution);
}

py::object of_compass(const RobotHandle& robot, const Numbers& reading, const Numbers& heading,
                      double resolution) {
  return compass_probabilities(model_of(robot), reading, heading, resolution);
}

py::object of_gyroscope(const RobotHandle& robot, const Numbers& reading, const Numbers& rate,
                        double resolution, double elapsed) {
  return gyroscope_probabilities(model_of(robot), reading, rate, resolution, elapsed);
}

py::object of_accelerometer(const RobotHandle& robot, const Numbers& reading,
                            const Numbers& acceleration, double resolution) {
  return accelerometer_probabilities(model_of(robot), reading, acceleration, resolution);
}

py::object of_encoder(const RobotHandle& robot, const Numbers& ticks, const Numbers& angle,
                      double resolution) {
  return encoder_probabilities(model_of(robot), ticks, angle, resolution);
}

}  // namespace

void bind_likelihood(py::module_& module) {
  auto robot = py::reinterpret_borrow<py::class_<RobotHandle>>(module.attr("Robot"));
  robot
      .def("psd_probability", &of_psd, py::arg("id"), py::arg("reading"), py::arg("distance"),
           py::arg("resolution") = 0.001, py::arg("cross_talkers") = py::none())
      .def("lidar_probability", &of_lidar, py::arg("reading"), py::arg("distance"),
           py::arg("resolution") = 0.001)
      .def("compass_probability", &of_compass, py::arg("reading"), py::arg("heading"),
           py::arg("resolution") = 0.01)
      .def("gyroscope_probability", &of_gyroscope, py::arg("reading"), py::arg("rate"),
           py::arg("resolution") = 0.001, py::arg("elapsed") = 0.0)
      .def("accelerometer_probability", &of_accelerometer, py::arg("reading"),
           py::arg("acceleration"), py::arg("resolution") = 0.01)
      .def("encoder_probability", &of_encoder, py::arg("ticks"), py::arg("angle"),
           py::arg("resolution") = 1.0);
}

}  // namespace eyebridge::python
