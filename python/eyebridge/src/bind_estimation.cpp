// EKF on landmarks, scan matching and SLAM.
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "eyebridge/localisation/grid_slam.hpp"
#include "eyebridge/localisation/landmark_ekf.hpp"
#include "eyebridge/localisation/scan_matcher.hpp"
#include "scans.hpp"

namespace eyebridge::python {
namespace {

namespace py = pybind11;
using localisation::GridSlam;
using localisation::LandmarkEkf;
using localisation::MatchSettings;
using localisation::OdometryNoise;
using localisation::OdometryStep;
using localisation::ScanMatcher;
using mapping::CellState;
using mapping::OccupancyGrid;

/// x, y and theta, row by row.
py::array_t<double> array_from(const localisation::Matrix3& matrix) {
  std::vector<double> cells;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) cells.push_back(matrix(row, column));
  }
  return array_of(std::move(cells)).reshape({3, 3});
}

LandmarkEkf ekf(const Place& pose, double position_sigma, double heading_sigma) {
  const auto is_length = [](double value) { return value >= 0 && std::isfinite(value); };
  if (!is_length(position_sigma)) refuse("position_sigma", position_sigma, "0 m or more");
  if (!is_length(heading_sigma)) refuse("heading_sigma", heading_sigma, "0 or more");
  localisation::PoseEstimate start{pose_from(pose), {}};
  start.covariance(0, 0) = start.covariance(1, 1) = position_sigma * position_sigma;
  start.covariance(2, 2) = heading_sigma * heading_sigma;
  return LandmarkEkf(start);
}

bool see(LandmarkEkf& filter, const std::pair<double, double>& landmark, double range,
         double bearing, double range_sigma, double bearing_sigma) {
  for (const double value : {landmark.first, landmark.second}) need_finite("landmark", value);
  if (!(range > 0 && std::isfinite(range))) refuse("range", range, "a length of more than 0 m");
  need_finite("bearing", bearing);
  return filter
      .update({landmark.first, landmark.second}, {range, bearing}, {range_sigma, bearing_sigma})
      .accepted;
}

void bind_ekf(py::module_& module) {
  const localisation::SightingNoise usual;
  py::class_<LandmarkEkf>(module, "LandmarkEkf")
      .def(py::init(&ekf), py::arg("pose"), py::kw_only(), py::arg("position_sigma") = 0.1,
           py::arg("heading_sigma") = 0.1)
      .def(
          "predict",
          [](LandmarkEkf& filter, const Place& before, const Place& after) {
            filter.predict(OdometryStep::between(pose_from(before), pose_from(after)),
                           OdometryNoise{});
          },
          py::arg("before"), py::arg("after"))
      .def("update", &see, py::arg("landmark"), py::arg("range"), py::arg("bearing"), py::kw_only(),
           py::arg("range_sigma") = usual.range_sigma,
           py::arg("bearing_sigma") = usual.bearing_sigma)
      .def_property_readonly(
          "estimate", [](const LandmarkEkf& filter) { return place_of(filter.estimate().pose); })
      .def_property_readonly(
          "covariance",
          [](const LandmarkEkf& filter) { return array_from(filter.estimate().covariance); })
      .def(
          "nees",
          [](const LandmarkEkf& filter, const Place& truth) {
            return localisation::normalised_error_squared(filter.estimate(), pose_from(truth));
          },
          py::arg("truth"));
}

ScanMatcher matcher(const OccupancyGrid& grid, double window, double turn_window, double sigma,
                    double least_score) {
  MatchSettings settings;
  settings.window = window;
  settings.turn_window = turn_window;
  settings.sigma = sigma;
  settings.least_score = least_score;
  return {mapping::cells_in(grid, {CellState::Occupied}), settings};
}

void bind_matcher(py::module_& module) {
  const MatchSettings usual;
  using Match = std::pair<Place, double>;
  py::class_<ScanMatcher>(module, "ScanMatcher")
      .def(py::init(&matcher), py::arg("grid"), py::kw_only(), py::arg("window") = usual.window,
           py::arg("turn_window") = usual.turn_window, py::arg("sigma") = usual.sigma,
           py::arg("least_score") = usual.least_score)
      .def(
          "match",
          [](const ScanMatcher& matcher, const Place& guess, const Numbers& ranges,
             const Numbers& bearings, double max_range) -> std::optional<Match> {
            const auto found =
                matcher.match(pose_from(guess), scan_from(ranges, bearings, max_range));
            if (!found) return std::nullopt;
            return Match(place_of(found->estimate.pose), found->score);
          },
          py::arg("guess"), py::arg("ranges"), py::arg("bearings"), py::kw_only(),
          py::arg("max_range") = 9.999);
}

/// SLAM, and how far its scanner looks.
struct Slam {
  GridSlam slam;
  double max_range;
};

Slam make_slam(const OccupancyGrid& grid, const Place& start, double max_range, double sigma) {
  if (!(max_range > 0 && std::isfinite(max_range))) refuse("max_range", max_range, "more than 0 m");
  if (!(sigma >= 0 && std::isfinite(sigma))) refuse("sigma", sigma, "0 m or more");
  localisation::GridSlamSettings settings;
  settings.geometry = grid.geometry();
  settings.occupancy = grid.settings();
  settings.beam.max_range = max_range;
  settings.beam.out_of_range = max_range;
  settings.beam.sigma = sigma;
  return {GridSlam(settings, pose_from(start)), max_range};
}

std::string add_scan(Slam& self, const Place& odometry, const Numbers& ranges,
                     const Numbers& bearings) {
  const auto outcome =
      self.slam.add(pose_from(odometry), scan_from(ranges, bearings, self.max_range));
  if (!outcome) throw std::runtime_error(outcome.error().what);
  switch (*outcome) {
    case GridSlam::Outcome::Skipped:
      return "skipped";
    case GridSlam::Outcome::Added:
      return "added";
    case GridSlam::Outcome::Unmatched:
      break;
  }
  return "unmatched";
}

void bind_slam(py::module_& module) {
  py::class_<Slam>(module, "GridSlam")
      .def(py::init(&make_slam), py::arg("grid"), py::arg("start"), py::kw_only(),
           py::arg("max_range") = 9.999, py::arg("sigma") = 0.01)
      .def("add", &add_scan, py::arg("odometry"), py::arg("ranges"), py::arg("bearings"))
      .def_property_readonly("pose", [](const Slam& self) { return place_of(self.slam.pose()); })
      .def_property_readonly(
          "map", [](const Slam& self) { return std::make_shared<OccupancyGrid>(self.slam.map()); })
      .def_property_readonly("unmatched", [](const Slam& self) { return self.slam.unmatched(); });
}

}  // namespace

void bind_estimation(py::module_& module) {
  bind_ekf(module);
  bind_matcher(module);
  bind_slam(module);
}

}  // namespace eyebridge::python
