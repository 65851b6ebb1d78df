#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "eyebridge/localisation/motion_model.hpp"
#include "eyebridge/mapping/raster.hpp"

namespace eyebridge::localisation {

/// How the ends of beams scatter about what they met.
struct BeamSettings {
  double sigma = 0.05;      ///< Of the distance from the nearest occupied cell, metres, > 0.
  double z_hit = 0.9;       ///< Share of beams that meet what the map knows, 0 … 1.
  double z_random = 0.1;    ///< Share of those that end anywhere, > 0, at most 1.
  double max_range = 10.0;  ///< Metres, > 0: over which the latter are spread evenly.
};

/// How likely beams are to end where they do, by the distance to the nearest occupied cell of a
/// map: the likelihood field of S. Thrun, W. Burgard and D. Fox, "Probabilistic Robotics" (2005),
/// section 6.4, table 6.3, with the logarithms taken once a cell. Outside of the map only chance
/// beams end. Beams that met nothing say nothing. Immutable after construction; any thread.
class LikelihoodField {
 public:
  /// `occupied` != 0 is what beams meet. Throws std::invalid_argument for settings out of range and
  /// for a map without cells.
  LikelihoodField(const mapping::Raster<std::uint8_t>& occupied, const BeamSettings& settings);

  [[nodiscard]] const mapping::GridGeometry& geometry() const { return geometry_; }
  /// Logarithm of the density of a beam's end at `point` in the world, in 1 / m.
  [[nodiscard]] double at(Vec2 point) const;
  /// The same in the middle of something occupied: no beam is more likely.
  [[nodiscard]] double highest() const { return highest_; }
  /// Sum over the ends `hits`, given in the frame of a robot at `pose`.
  [[nodiscard]] double log_likelihood(const Pose& pose, std::span<const Vec2> hits) const;
  /// That of every particle; `out` is as long as they are many.
  void log_likelihoods(const Particles& particles, std::span<const Vec2> hits,
                       std::span<double> out) const;

 private:
  mapping::GridGeometry geometry_;
  double cells_per_metre_;
  double last_column_;  ///< Of the table, which has a border of one cell about the map's.
  double last_row_;
  std::uint32_t stride_;
  double highest_;
  std::vector<float> table_;
};

}  // namespace eyebridge::localisation
