#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <pybind11/stl.h>

#include "bindings.hpp"
#include "eyebridge/base/random.hpp"
#include "eyebridge/mapping/occupancy_grid.hpp"
#include "eyebridge/planning/astar.hpp"
#include "eyebridge/planning/clearance.hpp"
#include "eyebridge/planning/dstar_lite.hpp"
#include "eyebridge/planning/frontiers.hpp"
#include "eyebridge/planning/potential_field.hpp"
#include "eyebridge/planning/pure_pursuit.hpp"
#include "eyebridge/planning/rrt_star.hpp"
#include "eyebridge/planning/sight.hpp"
#include "eyebridge/planning/theta_star.hpp"
#include "eyebridge/planning/wavefront.hpp"
#include "paths.hpp"

namespace eyebridge::python {
namespace {

namespace py = pybind11;
using mapping::OccupancyGrid;
using planning::BlockedRaster;

planning::Planned plan_by(const std::string& method, const BlockedRaster& blocked, Vec2 start,
                          Vec2 goal, std::uint64_t seed) {
  if (method == "astar") return planning::astar(blocked, start, goal);
  if (method == "theta_star") return planning::theta_star(blocked, start, goal);
  if (method == "dstar_lite") return planning::DStarLite(blocked, goal).plan(start);
  if (method == "wavefront") {
    const std::vector<Vec2> goals{goal};
    return planning::path_down(blocked, planning::wavefront(blocked, goals), start);
  }
  if (method == "potential_field") {
    return planning::follow_potential(blocked, planning::clearance_of(blocked), start, goal);
  }
  if (method != "rrt_star") {
    refuse("method", method,
           "astar, theta_star, dstar_lite, wavefront, rrt_star or potential_field");
  }
  Random random(seed);
  return planning::rrt_star(blocked, start, goal, random);
}

std::optional<py::array_t<double>> plan(const OccupancyGrid& grid, const Point& start,
                                        const Point& goal, double radius, const std::string& method,
                                        bool unknown_blocks, bool shorten, std::uint64_t seed) {
  const BlockedRaster blocked = blocked_of(grid, radius, unknown_blocks);
  planning::Planned path = plan_by(method, blocked, vec(start), vec(goal), seed);
  if (path) {
    return rows_of(shorten ? planning::shortened(blocked, *path).points : path->points);
  }
  need_ends(path.error());
  return std::nullopt;
}

std::optional<py::array_t<double>> explore(const OccupancyGrid& grid, const Point& position,
                                           double radius, std::size_t smallest) {
  if (!(radius >= 0)) refuse("radius", radius, "0 m or more");
  const auto next =
      planning::nearest_frontier(mapping::states_of(grid), vec(position), {radius, smallest});
  if (next) return rows_of(next->path.points);
  if (next.error() == planning::NoPath::Unreachable) return std::nullopt;
  throw std::invalid_argument(planning::to_text(next.error()));
}

planning::PurePursuit pursuit(const std::vector<Point>& path, double lookahead, double speed,
                              double max_angular, double deceleration, double tolerance) {
  std::vector<Vec2> points;
  for (const Point& point : path) points.push_back(vec(point));
  return planning::PurePursuit(std::move(points),
                               {lookahead, speed, max_angular, deceleration, tolerance});
}

}  // namespace

void bind_planning(py::module_& module) {
  const planning::PurePursuitSettings usual;
  module.def("plan", &plan, py::arg("grid"), py::arg("start"), py::arg("goal"), py::kw_only(),
             py::arg("radius") = 0.0, py::arg("method") = "astar",
             py::arg("unknown_blocks") = false, py::arg("shorten") = false, py::arg("seed") = 1);
  module.def("explore", &explore, py::arg("grid"), py::arg("position"), py::kw_only(),
             py::arg("radius") = 0.0, py::arg("smallest") = 1);
  py::class_<planning::PurePursuit>(module, "PurePursuit")
      .def(py::init(&pursuit), py::arg("path"), py::kw_only(),
           py::arg("lookahead") = usual.lookahead, py::arg("speed") = usual.speed,
           py::arg("max_angular") = usual.max_angular, py::arg("deceleration") = usual.deceleration,
           py::arg("tolerance") = usual.tolerance)
      .def(
          "follow",
          [](planning::PurePursuit& pursuit, const std::tuple<double, double, double>& pose) {
            const auto [x, y, theta] = pose;
            const Twist twist = pursuit.follow({x, y, theta});
            return std::pair(twist.linear, twist.angular);
          },
          py::arg("pose"))
      .def_property_readonly("has_arrived", &planning::PurePursuit::has_arrived);
}

}  // namespace eyebridge::python
