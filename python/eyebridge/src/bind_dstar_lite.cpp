#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include <pybind11/stl.h>

#include "bindings.hpp"
#include "eyebridge/planning/dstar_lite.hpp"
#include "paths.hpp"

namespace eyebridge::python {
namespace {

namespace py = pybind11;
using mapping::OccupancyGrid;

/// A plan that follows what is learned about its map.
class Replanner {
 public:
  Replanner(std::shared_ptr<OccupancyGrid> grid, const Point& goal, double radius,
            bool unknown_blocks)
      : grid_(std::move(grid)),
        radius_(radius),
        unknown_blocks_(unknown_blocks),
        revision_(grid_->revision()),
        search_(blocked_of(*grid_, radius, unknown_blocks), vec(goal)) {}

  std::optional<py::array_t<double>> plan(const Point& start) {
    follow_map();
    const planning::Planned path = search_.plan(vec(start));
    expanded_ = path ? path->expanded : 0;
    if (path) return rows_of(path->points);
    need_ends(path.error());
    return std::nullopt;
  }

  [[nodiscard]] std::size_t expanded() const { return expanded_; }

 private:
  void follow_map() {
    if (revision_ == grid_->revision()) return;
    const planning::BlockedRaster now = blocked_of(*grid_, radius_, unknown_blocks_);
    if (now.geometry != search_.blocked().geometry) {
      throw std::invalid_argument("the map has other bounds now: plan anew");
    }
    revision_ = grid_->revision();
    mapping::Cell cell;
    for (cell.row = 0; cell.row < now.geometry.rows; ++cell.row) {
      for (cell.column = 0; cell.column < now.geometry.columns; ++cell.column) {
        search_.set_blocked(cell, now[cell] != 0);
      }
    }
  }

  std::shared_ptr<OccupancyGrid> grid_;
  double radius_;
  bool unknown_blocks_;
  std::uint64_t revision_;
  planning::DStarLite search_;
  std::size_t expanded_ = 0;
};

}  // namespace

void bind_dstar_lite(py::module_& module) {
  py::class_<Replanner>(module, "DStarLite")
      .def(py::init<std::shared_ptr<OccupancyGrid>, const Point&, double, bool>(),
           py::arg("grid").none(false), py::arg("goal"), py::kw_only(), py::arg("radius") = 0.0,
           py::arg("unknown_blocks") = false)
      .def("plan", &Replanner::plan, py::arg("start"))
      .def_property_readonly("expanded", &Replanner::expanded);
}

}  // namespace eyebridge::python
