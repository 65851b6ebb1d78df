#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "checks.hpp"
#include "eyebridge/camera/png.hpp"
#include "eyebridge/files/map_files.hpp"
#include "eyebridge/files/readers.hpp"
#include "eyebridge/mapping/ground_truth.hpp"
#include "eyebridge/mapping/occupancy_grid.hpp"
#include "eyebridge/mapping/picture.hpp"
#include "eyebridge/mapping/robot_mapper.hpp"
#include "robot_handle.hpp"

namespace eyebridge::python {
namespace {

namespace py = pybind11;
using mapping::OccupancyGrid;
using Grid = std::shared_ptr<OccupancyGrid>;
using PoseTuple = std::tuple<double, double, double>;

Pose pose_of(const PoseTuple& pose) {
  const auto [x, y, theta] = pose;
  return {x, y, theta};
}

void need_done(const Result<void>& result) {
  if (!result) throw std::invalid_argument(result.error().what);
}

Grid make_grid(double width, double height, double resolution, std::pair<double, double> origin,
               double prior, bool growing, double half_life) {
  if (!(width > 0 && width < 1e6)) refuse("width", width, "more than 0 m, less than 1e6");
  if (!(height > 0 && height < 1e6)) refuse("height", height, "more than 0 m, less than 1e6");
  if (!(resolution > 1e-6 && resolution < 1e6)) {
    refuse("resolution", resolution, "more than 1e-6 m, less than 1e6");
  }
  if (width / resolution * (height / resolution) > static_cast<double>(mapping::kMostMapCells)) {
    refuse("resolution", resolution,
           fmt::format("cells of which at most {} make {:g} x {:g} m", mapping::kMostMapCells,
                       width, height));
  }
  mapping::OccupancySettings settings;
  settings.prior = prior;
  settings.growing = growing;
  settings.half_life = half_life;
  const Vec2 corner{origin.first, origin.second};
  return std::make_shared<OccupancyGrid>(
      mapping::GridGeometry::covering(corner, width, height, resolution), settings);
}

/// What numpy looks at; of a grid that grows a copy, since its cells move when its bounds do.
py::array_t<float> log_odds(const Grid& grid) {
  const Grid owner = grid->settings().growing ? std::make_shared<OccupancyGrid>(*grid) : grid;
  const mapping::GridGeometry& geometry = owner->geometry();
  return view_of(
      owner->raster().cells.data(),
      {static_cast<py::ssize_t>(geometry.rows), static_cast<py::ssize_t>(geometry.columns)}, owner);
}

const char* state_name(mapping::CellState state) {
  switch (state) {
    case mapping::CellState::Free:
      return "free";
    case mapping::CellState::Occupied:
      return "occupied";
    case mapping::CellState::Unknown:
      break;
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

py::array_t<double> grid_probabilities(const OccupancyGrid& grid) {
  std::vector<double> all(grid.raster().cells.size());
  std::transform(grid.raster().cells.begin(), grid.raster().cells.end(), all.begin(),
                 [](float log_odds) { return mapping::probability_of(log_odds); });
  const auto rows = static_cast<py::ssize_t>(grid.geometry().rows);
  return array_of(std::move(all)).reshape({rows, py::ssize_t{-1}});
}

py::array_t<std::uint8_t> grid_picture(const OccupancyGrid& grid) {
  const auto owner = std::make_shared<mapping::Raster<std::uint8_t>>(mapping::picture_of(grid));
  return view_of(owner->cells.data(),
                 {static_cast<py::ssize_t>(grid.geometry().rows),
                  static_cast<py::ssize_t>(grid.geometry().columns)},
                 owner);
}

Grid truth_of(const files::Scenario& scenario, double resolution, bool objects) {
  mapping::TruthSettings settings;
  settings.resolution = resolution;
  settings.objects = objects;
  return std::make_shared<OccupancyGrid>(mapping::truth_of(scenario.world, settings));
}

mapping::RobotMapper mapper_of(const RobotHandle& robot) {
  return robot.simulation->with(
      [&](auto& sim) { return mapping::RobotMapper(sim.model(robot.index)); });
}

py::dict agreement(const OccupancyGrid& belief, const OccupancyGrid& truth, int tolerance) {
  const mapping::Agreement found = mapping::agreement(belief, truth, tolerance);
  py::dict out;
  out["observed"] = found.observed;
  out["agreeing"] = found.agreeing;
  out["share"] = found.share();
  return out;
}

using std::filesystem::path;

/// A picture as people look at it: the upper row first.
void write_picture(const OccupancyGrid& grid, const path& file) {
  const mapping::Raster<std::uint8_t> grey = mapping::picture_of(grid);
  camera::Frame frame;
  frame.width = grey.geometry.columns;
  frame.height = grey.geometry.rows;
  frame.stride = frame.width;
  frame.format = camera::PixelFormat::Grey8;
  frame.bytes.reserve(grey.cells.size());
  for (int row = grey.geometry.rows - 1; row >= 0; --row) {
    const auto first = grey.cells.begin() + row * grey.geometry.columns;
    frame.bytes.insert(frame.bytes.end(), first, first + grey.geometry.columns);
  }
  camera::write_png(frame, file);
}

void save_grid(const OccupancyGrid& grid, const path& file) {
  if (file.extension() == ".yaml") return files::save_map(grid, file);
  if (file.extension() == ".png") return write_picture(grid, file);
  if (file.extension() != ".csv") refuse("path", file.string(), ".yaml, .csv or .png");
  files::save_map_csv(grid, file);
}

Grid load_grid(const path& file) {
  if (file.extension() == ".csv") {
    return std::make_shared<OccupancyGrid>(
        files::read_map_csv(files::read_text_file(file), file.string()));
  }
  if (file.extension() != ".yaml") refuse("path", file.string(), ".yaml or .csv");
  std::vector<Warning> warnings;
  auto grid = std::make_shared<OccupancyGrid>(files::load_map(file, warnings));
  for (const Warning& warning : warnings) {
    if (PyErr_WarnEx(PyExc_UserWarning, warning.str().c_str(), 1) != 0)
      throw py::error_already_set();
  }
  return grid;
}

void bind_grid(py::module_& module) {
  py::class_<OccupancyGrid, Grid>(module, "OccupancyGrid")
      .def(py::init(&make_grid), py::arg("width"), py::arg("height"), py::kw_only(),
           py::arg("resolution") = 0.05, py::arg("origin") = std::pair(0.0, 0.0),
           py::arg("prior") = 0.5, py::arg("growing") = false, py::arg("half_life") = 0.0)
      .def_static("truth_of", &truth_of, py::arg("scenario"), py::kw_only(),
                  py::arg("resolution") = 0.05, py::arg("objects") = false)
      .def_static("load", &load_grid, py::arg("path"))
      .def("save", &save_grid, py::arg("path"))
      .def_property_readonly("resolution",
                             [](const OccupancyGrid& grid) { return grid.geometry().resolution; })
      .def_property_readonly("origin",
                             [](const OccupancyGrid& grid) {
                               const Vec2 corner = grid.geometry().origin;
                               return py::make_tuple(corner.x, corner.y);
                             })
      .def_property_readonly("shape",
                             [](const OccupancyGrid& grid) {
                               return py::make_tuple(grid.geometry().rows, grid.geometry().columns);
                             })
      .def_property_readonly("revision", &OccupancyGrid::revision)
      .def_property_readonly("log_odds", &log_odds)
      .def_property_readonly("probabilities", &grid_probabilities)
      .def_property_readonly("picture", &grid_picture)
      .def(
          "probability",
          [](const OccupancyGrid& grid, double x, double y) {
            return grid.probability(Vec2{x, y});
          },
          py::arg("x"), py::arg("y"))
      .def(
          "state",
          [](const OccupancyGrid& grid, double x, double y) {
            return state_name(grid.state(Vec2{x, y}));
          },
          py::arg("x"), py::arg("y"))
      .def("set_probability", &set_probability, py::arg("x"), py::arg("y"), py::arg("probability"))
      .def(
          "update",
          [](OccupancyGrid& grid, double x, double y, double probability) {
            need_done(grid.update({x, y}, probability));
          },
          py::arg("x"), py::arg("y"), py::arg("probability"))
      .def("clear", &OccupancyGrid::clear)
      .def(
          "decay",
          [](OccupancyGrid& grid, double seconds) {
            if (!(seconds >= 0)) refuse("seconds", seconds, "0 or more");
            grid.decay(seconds);
          },
          py::arg("seconds"))
      .def("agreement", &agreement, py::arg("truth"), py::arg("tolerance") = 1)
      .def(
          "coverage",
          [](const OccupancyGrid& belief, const OccupancyGrid& truth, double x, double y) {
            return mapping::coverage(belief, truth, {x, y});
          },
          py::arg("truth"), py::arg("x"), py::arg("y"));
}

}  // namespace

void bind_mapping(py::module_& module) {
  bind_grid(module);
  py::class_<mapping::RobotMapper>(module, "RobotMapper")
      .def(py::init(&mapper_of), py::arg("robot"))
      .def(
          "insert_range",
          [](mapping::RobotMapper& mapper, OccupancyGrid& grid, const PoseTuple& pose,
             std::size_t sensor,
             double range) { need_done(mapper.insert_range(grid, pose_of(pose), sensor, range)); },
          py::arg("grid"), py::arg("pose"), py::arg("sensor"), py::arg("range"))
      .def(
          "insert_ranges",
          [](mapping::RobotMapper& mapper, OccupancyGrid& grid, const PoseTuple& pose,
             const Numbers& ranges) {
            need_done(mapper.insert_ranges(
                grid, pose_of(pose), {ranges.data(), static_cast<std::size_t>(ranges.size())}));
          },
          py::arg("grid"), py::arg("pose"), py::arg("ranges"))
      .def(
          "insert_lidar",
          [](mapping::RobotMapper& mapper, OccupancyGrid& grid, const PoseTuple& pose,
             const Numbers& ranges, double field_of_view) {
            need_done(
                mapper.insert_lidar(grid, pose_of(pose), field_of_view,
                                    {ranges.data(), static_cast<std::size_t>(ranges.size())}));
          },
          py::arg("grid"), py::arg("pose"), py::arg("ranges"),
          py::arg("field_of_view") = 2 * std::numbers::pi);
}

}  // namespace eyebridge::python
