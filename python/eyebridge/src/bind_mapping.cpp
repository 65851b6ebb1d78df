#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <tuple>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "checks.hpp"
#include "eyebridge/files/maps.hpp"
#include "eyebridge/mapping/ground_truth.hpp"
#include "eyebridge/mapping/occupancy_grid.hpp"
#include "eyebridge/mapping/robot_mapper.hpp"
#include "robot_handle.hpp"

namespace eyebridge::python {
namespace {

namespace py = pybind11;
using mapping::OccupancyGrid;
using Grid = std::shared_ptr<OccupancyGrid>;
using Triple = std::tuple<double, double, double>;
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

Pose pose_of(const Triple& pose) {
  const auto [x, y, theta] = pose;
  return {x, y, theta};
}

void need(const Result<void>& result) {
  if (!result) throw std::invalid_argument(result.error().what);
}

Grid make(double width, double height, double resolution, std::pair<double, double> origin,
          double prior, bool growing, double half_life) {
  if (!(width > 0 && width < 1e6)) refuse("width", width, "more than 0 m, less than 1e6");
  if (!(height > 0 && height < 1e6)) refuse("height", height, "more than 0 m, less than 1e6");
  if (!(resolution > 0)) refuse("resolution", resolution, "more than 0 m");
  mapping::OccupancySettings settings;
  settings.prior = prior;
  settings.growing = growing;
  settings.half_life = half_life;
  const Vec2 corner{origin.first, origin.second};
  return std::make_shared<OccupancyGrid>(
      mapping::GridGeometry::covering(corner, width, height, resolution), settings);
}

py::array_t<float> log_odds(const Grid& grid) {
  const mapping::GridGeometry& geometry = grid->geometry();
  return view_of(grid->raster().cells.data(),
                 {static_cast<py::ssize_t>(geometry.rows), static_cast<py::ssize_t>(geometry.columns)},
                 grid);
}

const char* state_name(mapping::CellState state) {
  switch (state) {
    case mapping::CellState::Free: return "free";
    case mapping::CellState::Occupied: return "occupied";
    case mapping::CellState::Unknown: break;
  }
  return "unknown";
}

void set_probability(OccupancyGrid& grid, double x, double y, double probability) {
  const mapping::Cell cell = grid.cell_at({x, y});
  if (!grid.geometry().contains(cell)) {
    throw std::out_of_range(fmt::format("({:g}, {:g}) m is outside of the grid", x, y));
  }
  if (!(probability >= 0 && probability <= 1)) refuse("probability", probability, "0 ... 1");
  grid.set_probability(cell, probability);
}

}  // namespace
}  // namespace eyebridge::python
