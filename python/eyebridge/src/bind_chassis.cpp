// Robot's wheels one by one, and driving sideways: what docs/drives.md has.
#include <stdexcept>
#include <string>

#include <pybind11/stl.h>

#include "bindings.hpp"
#include "checks.hpp"
#include "robot_handle.hpp"

namespace eyebridge::python {
namespace {

namespace py = pybind11;
using Release = py::call_guard<py::gil_scoped_release>;

/// `use(simulation, index)`, without Python's lock where the caller has it no more.
template <class Use>
auto with(const RobotHandle& robot, const Use& use) {
  return robot.simulation->with([&](auto& sim) { return use(sim, robot.index); });
}

/// Numbers of motors and encoders begin at 1, as programs have them.
unsigned index_of(const char* what, int number, unsigned count) {
  if (number >= 1 && number <= static_cast<int>(count)) return static_cast<unsigned>(number - 1);
  throw std::out_of_range(
      fmt::format("this robot has no {} {}, expected 1 to {}", what, number, count));
}

unsigned motor_index(const robot::DriveModel& drive, int number) {
  return index_of("motor", number, drive.motor_count());
}

void set_twist(const RobotHandle& robot, double linear, double lateral, double angular) {
  need_finite("linear", linear);
  need_finite("lateral", lateral);
  need_finite("angular", angular);
  with(robot, [&](auto& sim, auto index) { sim.set_twist(index, {linear, lateral, angular}); });
}

void set_wheel(const RobotHandle& robot, int motor, double speed) {
  need_finite("speed", speed);
  with(robot, [&](auto& sim, auto index) {
    sim.set_wheel(index, motor_index(sim.model(index).drive, motor), speed);
  });
}

void set_motor(const RobotHandle& robot, int motor, double duty) {
  need_finite("duty", duty);
  with(robot, [&](auto& sim, auto index) {
    sim.set_motor_duty(index, motor_index(sim.model(index).drive, motor), duty);
  });
}

void set_steering(const RobotHandle& robot, double angle) {
  need_finite("angle", angle);
  with(robot, [&](auto& sim, auto index) {
    if (!sim.model(index).drive.facts().steers_front()) {
      throw std::invalid_argument("this robot has no front wheels to steer: it is no car");
    }
    sim.set_steering(index, angle);
  });
}

std::int64_t encoder(const RobotHandle& robot, int number) {
  return with(robot, [&](auto& sim, auto index) {
    const unsigned count = sim.model(index).drive.encoder_count();
    return sim.encoder_ticks(index, index_of("encoder", number, count));
  });
}

void reset_encoder(const RobotHandle& robot, int number) {
  with(robot, [&](auto& sim, auto index) {
    const unsigned count = sim.model(index).drive.encoder_count();
    sim.reset_encoder(index, index_of("encoder", number, count));
  });
}

/// A property that `get(simulation, index)` reads.
template <class Get>
auto property(const Get& get) {
  return [get](const RobotHandle& robot) {
    const py::gil_scoped_release others_run;
    return with(robot, get);
  };
}

}  // namespace

void bind_chassis(py::module_& module) {
  auto robot = py::reinterpret_borrow<py::class_<RobotHandle>>(module.attr("Robot"));
  robot
      .def_property_readonly("drive_kind", property([](auto& sim, auto i) {
                               return std::string(sim.model(i).drive.facts().name);
                             }))
      .def_property_readonly("motor_count", property([](auto& sim, auto i) {
                               return sim.model(i).drive.motor_count();
                             }))
      .def_property_readonly("encoder_count", property([](auto& sim, auto i) {
                               return sim.model(i).drive.encoder_count();
                             }))
      .def_property_readonly("ticks_per_revolution", property([](auto& sim, auto i) {
                               return sim.model(i).drive.ticks_per_revolution;
                             }))
      .def_property_readonly("body_twist",
                             [](const RobotHandle& r) {
                               const HolonomicTwist twist = [&] {
                                 const py::gil_scoped_release others_run;
                                 return with(r,
                                             [](auto& sim, auto i) { return sim.body_twist(i); });
                               }();
                               return py::make_tuple(twist.linear, twist.lateral, twist.angular);
                             })
      .def_property_readonly("steering",
                             property([](auto& sim, auto i) { return sim.steering(i); }))
      .def_property_readonly("depth", property([](auto& sim, auto i) { return sim.depth(i); }))
      .def("set_twist", &set_twist, py::arg("linear"), py::arg("lateral") = 0.0,
           py::arg("angular") = 0.0, Release())
      .def("set_wheel", &set_wheel, py::arg("motor"), py::arg("speed"), Release())
      .def("set_motor", &set_motor, py::arg("motor"), py::arg("duty"), Release())
      .def("set_steering", &set_steering, py::arg("angle"), Release())
      .def("encoder", &encoder, py::arg("number"), Release())
      .def("reset_encoder", &reset_encoder, py::arg("number"), Release());
}

}  // namespace eyebridge::python
