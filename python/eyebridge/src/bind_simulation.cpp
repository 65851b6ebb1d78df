#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "checks.hpp"
#include "eyebridge/files/load.hpp"
#include "robot_handle.hpp"

namespace eyebridge::python {
namespace {

namespace py = pybind11;
using Release = py::call_guard<py::gil_scoped_release>;
using Shared = std::shared_ptr<SharedSimulation>;

Shared make(std::shared_ptr<files::Scenario> scenario, std::uint64_t seed, double step) {
  if (!scenario) scenario = std::make_shared<files::Scenario>(files::default_scenario());
  robot::SimulationSettings settings;
  settings.seed = seed;
  settings.step = step;
  const py::gil_scoped_release others_run;
  return std::make_shared<SharedSimulation>(std::move(scenario), settings);
}

void step(SharedSimulation& shared, long long steps) {
  if (steps < 0) refuse("steps", steps, "0 or more");
  shared.advance(steps);
}

void run(SharedSimulation& shared, double seconds) {
  if (!(seconds >= 0 && seconds < 1e9)) refuse("seconds", seconds, "0 ... 1e9");
  const double length = shared.with([](auto& sim) { return sim.settings().step; });
  shared.advance(std::llround(seconds / length));
}

/// `use(simulation)` without Python's lock: whoever waits for the simulation lets others run.
template <class Use>
auto of(const SharedSimulation& shared, Use&& use) {
  const py::gil_scoped_release others_run;
  return shared.with(std::forward<Use>(use));
}

py::array_t<double> poses(const SharedSimulation& shared) {
  const auto table = shared.table();
  return view_of(table->poses.data(), {static_cast<py::ssize_t>(shared.robot_count()), 3}, table);
}

py::array_t<double> twists(const SharedSimulation& shared) {
  const auto table = shared.table();
  return view_of(table->twists.data(), {static_cast<py::ssize_t>(shared.robot_count()), 2}, table);
}

void set_speeds(SharedSimulation& shared, const Numbers& speeds) {
  const auto count = static_cast<py::ssize_t>(shared.robot_count());
  if (speeds.ndim() != 2 || speeds.shape(0) != count || speeds.shape(1) != 2) {
    const std::vector<py::ssize_t> found(speeds.shape(), speeds.shape() + speeds.ndim());
    throw std::invalid_argument(
        fmt::format("found an array of shape ({}) for 'speeds', expected ({}, 2): linear and "
                    "angular speed of each robot",
                    fmt::join(found, ", "), count));
  }
  const double* next = speeds.data();
  for (py::ssize_t i = 0; i < 2 * count; ++i) need_finite("speeds", next[i]);
  of(shared, [&](auto& sim) {
    for (robot::RobotIndex i = 0; i < shared.robot_count(); ++i, next += 2) {
      sim.set_speed(i, {next[0], next[1]});
    }
  });
}

py::array_t<double> cast_rays(const SharedSimulation& shared, double x, double y,
                              const Numbers& angles, double max_range,
                              std::optional<robot::RobotIndex> ignore) {
  std::vector<Vec2> directions;
  const double* first = angles.data();
  for (py::ssize_t i = 0; i < angles.size(); ++i) {
    need_finite("angles", first[i]);
    directions.push_back(Heading::from_angle(first[i]).forward());
  }
  need_finite("x", x);
  need_finite("y", y);
  if (!(max_range > 0)) refuse("max_range", max_range, "more than 0");
  std::vector<double> ranges(directions.size());
  of(shared, [&](auto& sim) {
    const world::BodyId body = ignore ? sim.body(*ignore) : world::kNoBody;
    sim.world().cast_fan({x, y}, directions, max_range, body, ranges);
  });
  return array_of(std::move(ranges));
}

/// A row a robot; NaN beyond its sensors.
py::array_t<double> all_psds(const SharedSimulation& shared) {
  const std::size_t robots = shared.robot_count();
  std::size_t most = 0;
  std::vector<double> table = of(shared, [&](auto& sim) {
    std::vector<std::size_t> counts;
    for (robot::RobotIndex i = 0; i < robots; ++i) {
      counts.push_back(sim.model(i).range_sensors.size());
      most = std::max(most, counts.back());
    }
    std::vector<double> ranges(std::accumulate(counts.begin(), counts.end(), std::size_t{0}));
    sim.read_all_ranges(ranges);
    std::vector<double> rows(robots * most, std::numeric_limits<double>::quiet_NaN());
    auto next = ranges.begin();
    for (robot::RobotIndex i = 0; i < robots; next += static_cast<std::ptrdiff_t>(counts[i++])) {
      std::copy_n(next, counts[i], rows.data() + i * most);
    }
    return rows;
  });
  return array_of(std::move(table),
                  {static_cast<py::ssize_t>(robots), static_cast<py::ssize_t>(most)});
}

std::vector<RobotHandle> robot_handles(const Shared& shared) {
  std::vector<RobotHandle> out;
  for (robot::RobotIndex i = 0; i < shared->robot_count(); ++i) out.push_back({shared, i});
  return out;
}

}  // namespace

void bind_simulation(py::module_& module) {
  py::class_<SharedSimulation, Shared> simulation(module, "Simulation");
  bind_objects(simulation);
  simulation
      .def(py::init(&make), py::arg("scenario") = py::none(), py::kw_only(), py::arg("seed") = 1,
           py::arg("step") = 0.01)
      .def("step", &step, py::arg("steps") = 1, Release())
      .def("run", &run, py::arg("seconds"), Release())
      .def("reset", &SharedSimulation::reset, py::arg("seed") = py::none(), Release())
      .def("close", &SharedSimulation::close, Release())
      .def("__enter__", [](const Shared& shared) { return shared; })
      .def("__exit__",
           [](SharedSimulation& shared, const py::args&) {
             const py::gil_scoped_release others_run;
             shared.close();
           })
      .def_property_readonly("robots", &robot_handles)
      .def_property_readonly("poses", &poses)
      .def_property_readonly("twists", &twists)
      .def("psds", &all_psds)
      .def("set_speeds", &set_speeds, py::arg("speeds"))
      .def("cast_rays", &cast_rays, py::arg("x"), py::arg("y"), py::arg("angles"),
           py::arg("max_range") = 9.999, py::arg("ignore") = py::none())
      .def_property_readonly("time",
                             [](const SharedSimulation& shared) {
                               return of(shared, [](auto& sim) { return sim.time(); });
                             })
      .def_property_readonly("seed",
                             [](const SharedSimulation& shared) {
                               return of(shared, [](auto& sim) { return sim.settings().seed; });
                             })
      .def_property_readonly("step_length",
                             [](const SharedSimulation& shared) {
                               return of(shared, [](auto& sim) { return sim.settings().step; });
                             })
      .def_property_readonly("state_hash", [](const SharedSimulation& shared) {
        return of(shared, [](auto& sim) { return sim.state_hash(); });
      });
}

}  // namespace eyebridge::python
