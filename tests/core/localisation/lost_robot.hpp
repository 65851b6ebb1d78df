#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "eyebridge/localisation/monte_carlo.hpp"
#include "tour.hpp"

namespace eyebridge::localisation::testing {

constexpr std::size_t kBeams = 60;
constexpr double kCell = 0.05;

/// Monte-Carlo localisation in the flat, with no idea of where the robot is.
inline MonteCarlo lost_in_the_flat(const robot::RobotModel& model, std::uint64_t seed) {
  const auto walls = walls_in(flat(), kCell);
  MonteCarloSettings settings;
  settings.most_particles = 8000;
  // A stop every 0.1 m, a step of the simulation every 3 mm.
  settings.motion = odometry_noise(model.drive_error, model.drive, 0.1, 0.003);
  return {std::make_shared<const LikelihoodField>(walls, BeamSettings{0.06, 0.9, 0.1, 10.0}),
          room_for(flat(), walls, model.radius()), settings, seed};
}

/// Goes along a tour, from stop `first` on.
inline void follow(MonteCarlo& filter, const std::vector<Stop>& stops, std::size_t first = 0) {
  for (std::size_t i = first; i < stops.size(); ++i) {
    if (i > first) filter.predict(stops[i - 1].odometry, stops[i].odometry);
    filter.correct(stops[i].scan.thinned(kBeams));
  }
}

/// Whether it knows where the robot is: to 5 cm and 3 degrees.
inline bool knows(const MonteCarlo& filter, const Pose& truth) {
  const Cluster best = filter.estimate();
  return distance(best.estimate.pose, truth) <= 0.05 &&
         turn_between(best.estimate.pose, truth) <= deg_to_rad(3);
}

}  // namespace eyebridge::localisation::testing
