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

py::tuple as_tuple(const Pose& pose) { return py::make_tuple(pose.x, pose.y, pose.theta); }

/// Kind, number, name, where it sits in the robot, and how far it reaches (0: not by distance).
using SensorRow = std::tuple<std::string, int, std::string, py::tuple, double>;

std::vector<SensorRow> sensors(const ControlWorld& world, std::size_t index) {
  const robot::RobotModel& model = world.model(index);
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
  add("compass", 1, "compass", {}, 0);
  return rows;
}

py::object read_sensor(ControlWorld& world, std::size_t index, const std::string& kind, int id) {
  hal::Backend& robot = world.robot(index);
  if (kind == "psd") return py::cast(need(need(robot.range_sensor(id), "psd", id).read()));
  if (kind == "ir") return py::cast(need(need(robot.proximity(id), "ir", id).read()));
  if (kind == "bumper") return py::cast(need(need(robot.bumper(id), "bumper", id).read()));
  if (kind == "compass") return py::cast(need(need(robot.compass(), "compass", 1).read()));
  if (kind != "lidar") throw std::out_of_range("sensor " + kind);
  hal::Lidar& lidar = need(robot.lidar(), "lidar", 1);
  py::array_t<double> ranges(lidar.points());
  need(lidar.read({ranges.mutable_data(), static_cast<std::size_t>(ranges.size())}));
  return ranges;
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

using Wheels = std::vector<std::pair<std::string, int>>;

/// What docs/drives.md calls the motors of this kind of drive, and their numbers.
Wheels motors(const ControlWorld& world, std::size_t index) {
  switch (world.model(index).drive.kind) {
    case robot::DriveKind::Differential:
      break;
    case robot::DriveKind::Ackermann:
      return {{"drive", 1}};
    case robot::DriveKind::Omni:
      return {{"front left", 1}, {"front right", 2}, {"rear left", 3}, {"rear right", 4}};
    case robot::DriveKind::Swedish:
      return {{"front left", 1}, {"front right", 2}, {"rear", 3}};
    case robot::DriveKind::Synchro:
      return {{"drive", 1}, {"steer", 2}};
  }
  return {{"left", 1}, {"right", 2}};
}

/// Those that have encoders: a car's are at its rear wheels.
Wheels encoders(const ControlWorld& world, std::size_t index) {
  if (world.model(index).drive.kind != robot::DriveKind::Ackermann) return motors(world, index);
  return {{"left", 1}, {"right", 2}};
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
      .def("open_windows", &World::open_windows, py::arg("folder"), Release())
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
      .def("sensors", &sensors)
      .def("read", &read_sensor)
      .def("lidar_bearings", &lidar_bearings)
      .def("field_of_view",
           [](World& world, std::size_t index) {
             return need(world.robot(index).lidar(), "lidar", 1).shape().field_of_view;
           })
      .def("belief", &belief, py::arg("resolution"))
      .def("truth_grid", &truth_grid, py::arg("resolution"))
      .def("mapper",
           [](const World& world, std::size_t index) { return RobotMapper(world.model(index)); })
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
