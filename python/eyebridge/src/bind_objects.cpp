#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "checks.hpp"
#include "object_spec.hpp"
#include "shared_simulation.hpp"

namespace eyebridge::python {
namespace {

namespace py = pybind11;

/// `use(world)` without Python's lock.
template <class Use>
auto in_world(const SharedSimulation& shared, Use&& use) {
  const py::gil_scoped_release others_run;
  return shared.with([&](auto& sim) { return use(sim.world()); });
}

/// The body of an object that is there. Throws std::out_of_range.
world::BodyId body_there(const world::World& world, std::size_t object) {
  if (object >= world.object_count()) {
    throw std::out_of_range(
        fmt::format("no object {}, the world has {}", object, world.object_count()));
  }
  const world::BodyId body = world.object_body(object);
  if (!world.is_there(body)) {
    throw std::out_of_range(fmt::format("object {} has been removed", object));
  }
  return body;
}

py::array_t<double> objects(const SharedSimulation& shared) {
  std::vector<double> rows = in_world(shared, [](const world::World& world) {
    std::vector<double> out;
    for (std::size_t i = 0; i < world.object_count(); ++i) {
      const Pose pose = world.pose(world.object_body(i));
      out.insert(out.end(), {pose.x, pose.y, pose.theta});
    }
    return out;
  });
  return array_of(std::move(rows)).reshape({-1, 3});
}

std::size_t add_object(SharedSimulation& shared, const world::ObjectSpec& object) {
  return in_world(shared, [&](world::World& world) {
    world.add_object(object);
    return world.object_count() - 1;
  });
}

void remove_object(SharedSimulation& shared, std::size_t object) {
  in_world(shared, [&](world::World& world) { world.remove(body_there(world, object)); });
}

void set_object_pose(SharedSimulation& shared, std::size_t object, double x, double y,
                     double theta) {
  need_finite("x", x);
  need_finite("y", y);
  need_finite("theta", theta);
  in_world(shared, [&](world::World& world) {
    world.set_pose(body_there(world, object), {x, y, theta});
  });
}

void set_object_velocity(SharedSimulation& shared, std::size_t object, double x, double y) {
  need_finite("x", x);
  need_finite("y", y);
  in_world(shared, [&](world::World& world) {
    const world::BodyId body = body_there(world, object);
    if (!world.slides(body)) {
      refuse("object", object, "a ball, or one with a friction, that is not fixed");
    }
    world.set_velocity(body, {x, y});
  });
}

void set_object_fixed(SharedSimulation& shared, std::size_t object, bool fixed) {
  in_world(shared, [&](world::World& world) {
    const world::BodyId body = body_there(world, object);
    if (world.moves_by_itself(body)) refuse("object", object, "one that does not move by itself");
    world.set_fixed(body, fixed);
  });
}

void change_object(SharedSimulation& shared, std::size_t object, const std::string& lines) {
  in_world(shared, [&](world::World& world) {
    const world::BodyId body = body_there(world, object);
    world.change_object(body,
                        files::read_object_change(world.object(body), lines, "change_object"));
  });
}

}  // namespace

void bind_objects(py::class_<SharedSimulation, std::shared_ptr<SharedSimulation>>& simulation) {
  define_add_object(simulation, &add_object);
  simulation.def_property_readonly("objects", &objects)
      .def("remove_object", &remove_object, py::arg("object"))
      .def("set_object_pose", &set_object_pose, py::arg("object"), py::arg("x"), py::arg("y"),
           py::arg("theta") = 0.0)
      .def("set_object_velocity", &set_object_velocity, py::arg("object"), py::arg("x"),
           py::arg("y"))
      .def("set_object_fixed", &set_object_fixed, py::arg("object"), py::arg("fixed") = true)
      .def("change_object", &change_object, py::arg("object"), py::arg("lines"));
}

}  // namespace eyebridge::python
