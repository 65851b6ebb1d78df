#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "eyebridge/localisation/monte_carlo.hpp"
#include "eyebridge/mapping/occupancy_grid.hpp"
#include "scans.hpp"

namespace eyebridge::python {
namespace {

namespace py = pybind11;
using localisation::MonteCarlo;
using mapping::CellState;
using mapping::OccupancyGrid;

constexpr std::size_t kBeams = 60;  // as many as say something new

/// A filter, and how far its scanner looks.
struct Localiser {
  MonteCarlo filter;
  double max_range;
};

/// On the map `grid`: beams meet what is occupied, robots are where it is free.
Localiser monte_carlo(const OccupancyGrid& grid, double sigma, double max_range,
                      std::size_t particles, std::uint64_t seed) {
  const auto occupied = mapping::cells_in(grid, {CellState::Occupied});
  const auto free = mapping::cells_in(grid, {CellState::Free});
  localisation::BeamSettings beams;
  beams.sigma = sigma;
  beams.max_range = max_range;
  localisation::MonteCarloSettings settings;
  settings.most_particles = particles;
  settings.least_particles = std::min(settings.least_particles, particles);
  auto field = std::make_shared<const localisation::LikelihoodField>(occupied, beams);
  return {{std::move(field), free, settings, seed}, max_range};
}

void correct(Localiser& localiser, const Numbers& ranges, const Numbers& bearings) {
  const localisation::Scan scan = scan_from(ranges, bearings, localiser.max_range);
  localiser.filter.correct(scan.thinned(kBeams));
}

}  // namespace

void bind_localisation(py::module_& module) {
  py::class_<Localiser>(module, "MonteCarlo")
      .def(py::init(&monte_carlo), py::arg("grid"), py::kw_only(), py::arg("sigma") = 0.05,
           py::arg("max_range") = 9.999, py::arg("particles") = 20000, py::arg("seed") = 1)
      .def("start_anywhere", [](Localiser& localiser) { localiser.filter.start_anywhere(); })
      .def(
          "start_at",
          [](Localiser& localiser, const Place& pose, double position, double heading) {
            localiser.filter.start_at(pose_from(pose), position, heading);
          },
          py::arg("pose"), py::arg("position_sigma") = 0.1, py::arg("heading_sigma") = 0.1)
      .def(
          "predict",
          [](Localiser& localiser, const Place& before, const Place& after) {
            localiser.filter.predict(pose_from(before), pose_from(after));
          },
          py::arg("before"), py::arg("after"))
      .def("correct", &correct, py::arg("ranges"), py::arg("bearings"))
      .def_property_readonly("estimate",
                             [](const Localiser& localiser) {
                               const Pose& pose = localiser.filter.estimate().estimate.pose;
                               return py::make_tuple(pose.x, pose.y, pose.theta);
                             })
      .def_property_readonly("deviation",
                             [](const Localiser& localiser) {
                               const auto spread = localiser.filter.estimate().estimate.covariance;
                               return std::pair(std::sqrt(spread(0, 0) + spread(1, 1)),
                                                std::sqrt(spread(2, 2)));
                             })
      .def_property_readonly(
          "share", [](const Localiser& localiser) { return localiser.filter.estimate().share; })
      .def_property_readonly("particles", [](const Localiser& localiser) {
        const localisation::Particles& all = localiser.filter.particles();
        std::vector<double> rows;
        rows.reserve(4 * all.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
          rows.insert(rows.end(), {all.x[i], all.y[i], all.theta[i], all.weight[i]});
        }
        return array_of(std::move(rows)).reshape({-1, 4});
      });
}

}  // namespace eyebridge::python
