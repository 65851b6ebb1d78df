// eyebridge._control: the world that a control file drives. For eyebridge.control alone, which says
// what each function is.

#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "bind_things.hpp"
#include "control_sensors.hpp"
#include "control_world.hpp"
#include "eyebridge/mapping/ground_truth.hpp"
#include "eyebridge/mapping/occupancy_grid.hpp"
#include "eyebridge/mapping/picture.hpp"
#include "eyebridge/mapping/robot_mapper.hpp"

namespace eyebridge::python {
namespace {

namespace py = pybind11;
using mapping::OccupancyGrid;
using mapping::RobotMapper;
using mapping::truth_of;

/// Radians a second of wheel `wheel`, from 1.
void set_wheel(ControlWorld& world, std::size_t index, int wheel, double speed) {
  const double ticks = world.model(index).drive.ticks_per_revolution;
  need(need(world.robot(index).motor(wheel), "motor", wheel)
           .set_speed(speed / (2 * std::numbers::pi) * ticks));
}

/// The angle a wheel has turned by its encoder, radians.
double wheel_angle(ControlWorld& world, std::size_t index, int wheel) {
  const double ticks = world.model(index).drive.ticks_per_revolution;
  const int count = need(need(world.robot(index).encoder(wheel), "encoder", wheel).read());
  return count / ticks * 2 * std::numbers::pi;
}

hal::Drive& drive_of(ControlWorld& world, std::size_t index) {
  return need(world.robot(index).drive(), "drive", 1);
}

/// Nothing is known of it: the floor, and a cell around.
std::shared_ptr<OccupancyGrid> belief(const ControlWorld& world, double resolution) {
  return std::make_shared<OccupancyGrid>(
      truth_of(*world.scene().model, {.resolution = resolution}).geometry());
}

std::shared_ptr<OccupancyGrid> truth_grid(const ControlWorld& world, double resolution) {
  return std::make_shared<OccupancyGrid>(
      truth_of(*world.scene().model, {.resolution = resolution}));
}

using MapPose = std::tuple<int, double, double, double>;

/// Shows a grid and the robots in it in the window's dock.
void show(robios::MapBoard& board, const OccupancyGrid& grid, const std::vector<MapPose>& robots,
          const ControlWorld& world) {
  robios::MapLook look{mapping::picture_of(grid, mapping::PictureKind::Probabilities), {}};
  for (const auto& [number, x, y, theta] : robots) {
    const double radius = world.model(static_cast<std::size_t>(number - 1)).radius();
    look.robots.push_back({number, {x, y, theta}, radius});
  }
  board.show(std::move(look));
}

}  // namespace
}  // namespace eyebridge::python

PYBIND11_MODULE(_control, module) {
  using namespace eyebridge::python;
  using World = ControlWorld;
  using eyebridge::mapping::RobotMapper;
  using Release = py::call_guard<py::gil_scoped_release>;
  module.doc() = "The world of a control file; use it as `eyebridge.control`.";
  py::module_::import("eyebridge._core");  // has the classes of grids
  py::class_<World> bound(module, "World");
  bind_things(bound);
  bind_control_sensors(bound);
  bound.def(py::init<const std::filesystem::path&>(), py::arg("file"))
      .def("step", &World::step, Release())
      .def_property_readonly("step_length", &World::step_length)
      .def_property_readonly("robot_count", &World::robot_count)
      .def_property_readonly("is_closed", &World::is_closed)
      .def("setting",
           [](const World& world, const std::string& key) { return world.config().text(key); })
      .def("number",
           [](const World& world, const std::string& key) { return world.config().number(key); })
      .def("is_set",
           [](const World& world, const std::string& key) { return world.config().is_set(key); })
      .def_property_readonly("has_windows", &World::has_windows)
      .def("show_belief",
           [](World& world, const OccupancyGrid& grid, const std::vector<MapPose>& robots) {
             show(world.belief_board(), grid, robots, world);
           })
      .def("show_map",
           [](World& world, const OccupancyGrid& grid, const std::vector<MapPose>& robots) {
             show(world.map_board(), grid, robots, world);
           })
      .def("open_windows", &World::open_windows, Release())
      .def("note", &World::note, py::arg("name"), py::arg("value"))
      .def("resume", &World::resume)
      .def("end", &World::end, Release())
      .def("give_up", &World::give_up, Release())
      .def("finish", &World::finish, py::arg("how"), Release())
      .def("model_name",
           [](const World& world, std::size_t index) { return world.model(index).name; })
      .def("radius",
           [](const World& world, std::size_t index) { return world.model(index).radius(); })
      .def("wheel_base", [](const World& world,
                            std::size_t index) { return world.model(index).drive.wheel_base; })
      .def("wheel_diameter",
           [](const World& world, std::size_t index) {
             return world.model(index).drive.wheel_diameter;
           })
      .def("belief", &belief, py::arg("resolution"))
      .def("truth_grid", &truth_grid, py::arg("resolution"))
      .def("mapper",
           [](const World& world, std::size_t index) { return RobotMapper(world.model(index)); })
      .def("error_changes", &World::refresh)
      .def("set_errors",
           [](World& world, std::size_t index, const std::string& rules, double scale) {
             const auto done = world.environment().control().set_errors(static_cast<int>(index) + 1,
                                                                        rules, scale);
             if (!done) throw std::invalid_argument(done.error().what);
           })
      .def("motors", &motors)
      .def("encoders", &encoders)
      .def("set_wheel", &set_wheel)
      .def("wheel_angle", &wheel_angle)
      .def("set_twist",
           [](World& world, std::size_t index, double linear, double angular) {
             need(drive_of(world, index).set_speed({linear, angular}));
           })
      .def("odometry",
           [](World& world, std::size_t index) {
             return as_tuple(need(drive_of(world, index).odometry()));
           })
      .def("set_odometry",
           [](World& world, std::size_t index, double x, double y, double theta) {
             need(drive_of(world, index).set_odometry({x, y, theta}));
           })
      .def("stop", [](World& world, std::size_t index) { world.robot(index).stop(); })
      .def("truth", [](World& world, std::size_t index) { return as_tuple(world.truth(index)); });
}
