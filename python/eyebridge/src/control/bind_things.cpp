// Of eyebridge._control: objects of the world that a control file adds, moves and removes.

#include "bind_things.hpp"

#include <stdexcept>

#include <pybind11/stl.h>

#include "../object_spec.hpp"

namespace eyebridge::python {
namespace {

namespace py = pybind11;

hal::WorldControl& control_of(ControlWorld& world) { return world.environment().control(); }

/// LookupError for an object that is not there.
Pose pose_there(ControlWorld& world, int number) {
  const auto pose = control_of(world).object_pose(number);
  if (!pose) throw py::index_error(pose.error().what);
  return *pose;
}

/// `act` on an object that is there; ValueError with what was wrong.
template <class Act>
void on_object(ControlWorld& world, int number, Act act) {
  pose_there(world, number);
  const Result<void> done = act(control_of(world));
  if (!done) throw std::invalid_argument(done.error().what);
}

int add_object(ControlWorld& world, const world::ObjectSpec& object) {
  const auto number = control_of(world).add_object(object);
  if (!number) throw std::invalid_argument(number.error().what);
  return *number;
}

}  // namespace

void bind_things(py::class_<ControlWorld>& world) {
  define_add_object(world, &add_object);
  world
      .def_property_readonly("object_count",
                             [](ControlWorld& self) { return control_of(self).object_count(); })
      .def("is_object_there",
           [](ControlWorld& self, int number) {
             return control_of(self).object_pose(number).has_value();
           })
      .def("object_pose",
           [](ControlWorld& self, int number) {
             const Pose pose = pose_there(self, number);
             return py::make_tuple(pose.x, pose.y, pose.theta);
           })
      .def("set_object_pose",
           [](ControlWorld& self, int number, double x, double y, double theta) {
             on_object(self, number, [&](hal::WorldControl& control) {
               return control.set_object_pose(number, {x, y, theta});
             });
           })
      .def("set_object_velocity",
           [](ControlWorld& self, int number, double x, double y) {
             on_object(self, number, [&](hal::WorldControl& control) {
               return control.set_object_velocity(number, {x, y});
             });
           })
      .def("change_object",
           [](ControlWorld& self, int number, const std::string& lines) {
             on_object(self, number, [&](hal::WorldControl& control) {
               return control.change_object(number, lines);
             });
           })
      .def("set_object_fixed",
           [](ControlWorld& self, int number, bool fixed) {
             on_object(self, number, [&](hal::WorldControl& control) {
               return control.set_object_fixed(number, fixed);
             });
           })
      .def("remove_object", [](ControlWorld& self, int number) {
        on_object(self, number,
                  [&](hal::WorldControl& control) { return control.remove_object(number); });
      });
}

}  // namespace eyebridge::python
