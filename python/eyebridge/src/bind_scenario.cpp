#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "checks.hpp"
#include "eyebridge/files/load.hpp"
#include "eyebridge/files/maze_limits.hpp"

namespace eyebridge::python {
namespace {

namespace py = pybind11;
using files::Scenario;

/// The script that Python runs; empty in an interactive session.
std::filesystem::path script() {
  const py::object file = py::getattr(py::module_::import("__main__"), "__file__", py::none());
  return file.is_none() ? std::filesystem::path() : file.cast<std::filesystem::path>();
}

std::shared_ptr<Scenario> load(const std::filesystem::path& path, const std::string& robot,
                               bool strict, std::optional<double> cell) {
  files::LoadOptions options;
  options.robot = robot;
  options.places = files::SearchPlaces::of_process(script());
  options.reading = strict ? files::Reading::Strict : files::Reading::Tolerant;
  options.cell = cell;
  if (cell && !(*cell >= files::kLeastMazeCell && *cell <= files::kMostMazeCell)) {
    refuse("cell", std::to_string(*cell), "0.01 to 100 m");
  }
  const py::gil_scoped_release others_run;
  return std::make_shared<Scenario>(files::load_scenario(path, options));
}

std::vector<std::string> warnings(const Scenario& scenario) {
  std::vector<std::string> lines;
  for (const Warning& warning : scenario.warnings) lines.push_back(warning.str());
  return lines;
}

/// One row a wall: its two ends.
py::array_t<double> walls(const Scenario& scenario) {
  std::vector<double> ends;
  for (const world::Wall& wall : scenario.world.walls) {
    ends.insert(ends.end(), {wall.a.x, wall.a.y, wall.b.x, wall.b.y});
  }
  return array_of(std::move(ends)).reshape({-1, 4});
}

/// One row a goal: the middle of its cell.
py::array_t<double> goals(const Scenario& scenario) {
  std::vector<double> places;
  if (scenario.world.maze) {
    const double cell = scenario.world.maze->cell;
    for (const world::MazeCell goal : scenario.world.maze->goals) {
      places.insert(places.end(), {(goal.column + 0.5) * cell, (goal.row + 0.5) * cell});
    }
  }
  return array_of(std::move(places)).reshape({-1, 2});
}

std::vector<std::string> robot_names(const Scenario& scenario) {
  std::vector<std::string> names;
  for (const files::RobotPlacement& placed : scenario.robots) {
    names.push_back(scenario.models.at(placed.model).name);
  }
  return names;
}

}  // namespace

void bind_scenario(py::module_& module) {
  py::class_<Scenario, std::shared_ptr<Scenario>>(module, "Scenario")
      .def_property_readonly(
          "size", [](const Scenario& s) { return py::make_tuple(s.world.width, s.world.height); })
      .def_property_readonly("robots", &robot_names)
      .def_property_readonly("walls", &walls)
      .def_property_readonly("goals", &goals)
      .def_property_readonly("warnings", &warnings)
      .def("__repr__", [](const Scenario& s) {
        return "<eyebridge.Scenario: " + std::to_string(s.world.walls.size()) + " walls, " +
               std::to_string(s.robots.size()) + " robots>";
      });
  module.def("load_scenario", &load, py::arg("path"), py::arg("robot") = "S4", py::kw_only(),
             py::arg("strict") = true, py::arg("cell") = py::none());
  module.def("default_scenario",
             [] { return std::make_shared<Scenario>(files::default_scenario()); });
}

}  // namespace eyebridge::python
