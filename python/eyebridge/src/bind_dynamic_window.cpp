#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include <pybind11/stl.h>

#include "bindings.hpp"
#include "eyebridge/mapping/occupancy_grid.hpp"
#include "eyebridge/planning/dynamic_window.hpp"
#include "scans.hpp"

namespace eyebridge::python {
namespace {

namespace py = pybind11;
using mapping::CellState;
using mapping::OccupancyGrid;
using planning::DynamicWindowSettings;

/// The method and the map that it looks at, which may change between two choices.
class Driver {
 public:
  Driver(std::shared_ptr<OccupancyGrid> grid, const DynamicWindowSettings& settings)
      : grid_(std::move(grid)), window_(settings) {}

  planning::DynamicChoice choose(const Pose& pose, const Twist& now, Vec2 goal) {
    if (revision_ != grid_->revision()) {
      clearance_ = planning::clearance_of(mapping::cells_in(*grid_, {CellState::Occupied}));
      revision_ = grid_->revision();
    }
    return window_.choose(clearance_, pose, now, goal);
  }

 private:
  std::shared_ptr<OccupancyGrid> grid_;
  planning::DynamicWindow window_;
  planning::ClearanceRaster clearance_;
  std::optional<std::uint64_t> revision_;
};

Driver driver(std::shared_ptr<OccupancyGrid> grid, double radius, double speed, double max_angular,
              double acceleration, double angular_acceleration, double period, double tolerance) {
  DynamicWindowSettings settings;
  settings.radius = radius;
  settings.max_linear = speed;
  settings.max_angular = max_angular;
  settings.linear_acceleration = acceleration;
  settings.angular_acceleration = angular_acceleration;
  settings.period = period;
  settings.tolerance = tolerance;
  return {std::move(grid), settings};
}

}  // namespace

void bind_dynamic_window(py::module_& module) {
  const DynamicWindowSettings usual;
  py::class_<Driver>(module, "DynamicWindow")
      .def(py::init(&driver), py::arg("grid").none(false), py::kw_only(),
           py::arg("radius") = usual.radius, py::arg("speed") = usual.max_linear,
           py::arg("max_angular") = usual.max_angular,
           py::arg("acceleration") = usual.linear_acceleration,
           py::arg("angular_acceleration") = usual.angular_acceleration,
           py::arg("period") = usual.period, py::arg("tolerance") = usual.tolerance)
      .def(
          "choose",
          [](Driver& driver, const Place& pose, const std::pair<double, double>& now,
             const std::pair<double, double>& goal) {
            for (const double value : {now.first, now.second}) need_finite("now", value);
            for (const double value : {goal.first, goal.second}) need_finite("goal", value);
            const planning::DynamicChoice choice =
                driver.choose(pose_from(pose), {now.first, now.second}, {goal.first, goal.second});
            return py::make_tuple(choice.twist.linear, choice.twist.angular, choice.is_braking);
          },
          py::arg("pose"), py::arg("now"), py::arg("goal"));
}

}  // namespace eyebridge::python
