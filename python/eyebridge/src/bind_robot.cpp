#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "checks.hpp"
#include "eyebridge/files/error_rules.hpp"
#include "robot_camera.hpp"
#include "robot_handle.hpp"

namespace eyebridge::python {
namespace {

namespace py = pybind11;
using Release = py::call_guard<py::gil_scoped_release>;

/// `read(simulation, index)` without Python's lock.
template <class Read>
auto of(const RobotHandle& robot, Read&& read) {
  const py::gil_scoped_release others_run;
  return robot.simulation->with([&](auto& sim) { return read(sim, robot.index); });
}

py::tuple as_tuple(const Pose& pose) { return py::make_tuple(pose.x, pose.y, pose.theta); }
py::tuple as_tuple(const Twist& twist) { return py::make_tuple(twist.linear, twist.angular); }

/// Index of the distance sensor that programs ask for as `id`.
std::size_t sensor_index(const robot::RobotModel& model, int id) {
  for (std::size_t i = 0; i < model.range_sensors.size(); ++i) {
    if (model.range_sensors[i].id == id) return i;
  }
  throw std::out_of_range("this robot has no PSD " + std::to_string(id));
}

double psd(const RobotHandle& robot, int id) {
  return of(robot, [id](auto& sim, auto index) {
    return sim.read_range(index, sensor_index(sim.model(index), id));
  });
}

py::array_t<double> psds(const RobotHandle& robot) {
  return array_of(of(robot, [](auto& sim, auto index) {
    std::vector<double> ranges(sim.model(index).range_sensors.size());
    sim.read_ranges(index, ranges);
    return ranges;
  }));
}

py::array_t<double> lidar(const RobotHandle& robot, std::optional<int> points,
                          std::optional<double> field_of_view, std::optional<double> tilt) {
  return array_of(of(robot, [&](auto& sim, auto index) {
    const std::optional<robot::LidarModel>& model = sim.model(index).lidar;
    if (!model) throw std::invalid_argument("this robot has no lidar");
    const int count = points.value_or(model->points);
    const double view = field_of_view.value_or(model->field_of_view);
    const double down = tilt.value_or(model->tilt);
    if (count < 1 || count > 36000) refuse("points", count, "1 ... 36000");
    if (!(view > 0 && view <= 2 * kPi + 1e-9)) {
      refuse("field_of_view", view, "more than 0 and at most 2 pi");
    }
    if (!(std::abs(down) <= kPi / 2)) refuse("tilt", down, "-pi/2 ... pi/2");
    std::vector<double> ranges(static_cast<std::size_t>(count));
    sim.read_lidar(index, view, down, ranges);
    return ranges;
  }));
}

/// Eight rows of eight.
py::array_t<double> range_matrix(const RobotHandle& robot, int id) {
  constexpr auto kSize = static_cast<py::ssize_t>(robot::kMatrixSize);
  py::array_t<double> ranges({kSize, kSize});
  of(robot, [&](auto& sim, auto index) {
    const auto& models = sim.model(index).range_matrices;
    const auto found = std::ranges::find(models, id, &robot::RangeMatrixModel::id);
    if (found == models.end()) throw py::index_error(fmt::format("no range matrix {}", id));
    sim.read_range_matrix(index, static_cast<std::size_t>(found - models.begin()),
                          {ranges.mutable_data(), static_cast<std::size_t>(ranges.size())});
    return 0;
  });
  return ranges;
}

void set_pose(RobotHandle& robot, double x, double y, double theta) {
  need_finite("x", x);
  need_finite("y", y);
  need_finite("theta", theta);
  robot.simulation->moving([&](auto& sim) { sim.set_pose(robot.index, {x, y, theta}); });
}

void set_speed(RobotHandle& robot, double linear, double angular) {
  need_finite("linear", linear);
  need_finite("angular", angular);
  robot.simulation->with([&](auto& sim) { sim.set_speed(robot.index, {linear, angular}); });
}

void drive(RobotHandle& robot, double distance, double angle, double speed) {
  need_finite("distance", distance);
  need_finite("angle", angle);
  need_finite("speed", speed);
  robot.simulation->with([&](auto& sim) {
    sim.drive(robot.index, {distance, angle, std::abs(speed)});
  });
}

void set_wheels(RobotHandle& robot, double left, double right) {
  need_finite("left", left);
  need_finite("right", right);
  robot.simulation->with([&](auto& sim) {
    sim.set_motor_duty(robot.index, 0, left);
    sim.set_motor_duty(robot.index, sim.model(robot.index).drive.facts().right_motor, right);
  });
}

void set_errors(RobotHandle& robot, const std::string& rules, double scale) {
  if (!(scale >= 0.0 && scale <= 1.0)) refuse("scale", scale, "0 ... 1");
  robot.simulation->with([&](auto& sim) {
    sim.set_errors(robot.index, files::with_errors(sim.model(robot.index), rules, scale));
  });
}

std::unique_ptr<RobotCamera> open_camera(const RobotHandle& robot, int width, int height,
                                         const std::string& options) {
  return std::make_unique<RobotCamera>(robot.simulation, robot.index, width, height,
                                       options.empty() ? "render" : "render?" + options);
}

}  // namespace

void bind_robot(py::module_& module) {
  using robot::DriveState;
  py::class_<RobotHandle>(module, "Robot")
      .def_property_readonly("index", [](const RobotHandle& r) { return r.index; })
      .def_property_readonly("name",
                             [](const RobotHandle& r) {
                               return of(r, [](auto& sim, auto i) { return sim.model(i).name; });
                             })
      .def_property_readonly("radius",
                             [](const RobotHandle& r) {
                               return of(r,
                                         [](auto& sim, auto i) { return sim.model(i).radius(); });
                             })
      .def_property_readonly(
          "pose",
          [](const RobotHandle& r) {
            return as_tuple(of(r, [](auto& sim, auto i) { return sim.pose(i); }));
          })
      .def_property_readonly(
          "twist",
          [](const RobotHandle& r) {
            return as_tuple(of(r, [](auto& sim, auto i) { return sim.twist(i); }));
          })
      .def_property_readonly(
          "odometry",
          [](const RobotHandle& r) {
            return as_tuple(of(r, [](auto& sim, auto i) { return sim.odometry(i); }));
          })
      .def_property_readonly("distance",
                             [](const RobotHandle& r) {
                               const py::gil_scoped_release others_run;
                               return r.simulation->distance(r.index);
                             })
      .def_property_readonly("collisions",
                             [](const RobotHandle& r) {
                               const py::gil_scoped_release others_run;
                               return r.simulation->collisions(r.index);
                             })
      .def_property_readonly("driving",
                             [](const RobotHandle& r) {
                               return of(r, [](auto& sim, auto i) {
                                 return sim.drive_state(i) == DriveState::Driving;
                               });
                             })
      .def_property_readonly("failed",
                             [](const RobotHandle& r) {
                               return of(r, [](auto& sim, auto i) {
                                 return sim.drive_state(i) == DriveState::Failed;
                               });
                             })
      .def_property_readonly(
          "stalled",
          [](const RobotHandle& r) {
            return of(r, [](auto& sim, auto i) { return sim.stalled(i) != robot::kStallNone; });
          })
      .def_property_readonly("encoders",
                             [](const RobotHandle& r) {
                               return of(r, [](auto& sim, auto i) {
                                 return std::pair(sim.encoder_ticks(i, 0), sim.encoder_ticks(i, 1));
                               });
                             })
      .def("set_pose", &set_pose, py::arg("x"), py::arg("y"), py::arg("theta"), Release())
      .def("set_speed", &set_speed, py::arg("linear"), py::arg("angular") = 0.0, Release())
      .def("drive", &drive, py::arg("distance") = 0.0, py::arg("angle") = 0.0,
           py::arg("speed") = 0.3, Release())
      .def("set_wheels", &set_wheels, py::arg("left"), py::arg("right"), Release())
      .def("stop", [](const RobotHandle& r) { of(r, [](auto& sim, auto i) { sim.stop(i); }); })
      .def("set_errors", &set_errors, py::arg("rules"), py::arg("scale") = 1.0, Release())
      .def("psd", &psd, py::arg("id"))
      .def("psds", &psds)
      .def_property_readonly("psd_ids",
                             [](const RobotHandle& r) {
                               return of(r, [](auto& sim, auto i) {
                                 std::vector<int> ids;
                                 for (const auto& sensor : sim.model(i).range_sensors)
                                   ids.push_back(sensor.id);
                                 return ids;
                               });
                             })
      .def("range_matrix", &range_matrix, py::arg("id"))
      .def("lidar", &lidar, py::arg("points") = py::none(), py::arg("field_of_view") = py::none(),
           py::arg("tilt") = py::none())
      .def("compass",
           [](const RobotHandle& r) {
             return of(r, [](auto& sim, auto i) { return sim.read_compass(i); });
           })
      .def("gyroscope",
           [](const RobotHandle& r) {
             return of(r, [](auto& sim, auto i) { return sim.read_gyroscope(i); });
           })
      .def("accelerometer",
           [](const RobotHandle& r) {
             const Vec2 felt = of(r, [](auto& sim, auto i) { return sim.read_accelerometer(i); });
             return py::make_tuple(felt.x, felt.y);
           })
      .def("camera", &open_camera, py::arg("width") = 320, py::arg("height") = 240,
           py::arg("options") = "", Release());
}

}  // namespace eyebridge::python
