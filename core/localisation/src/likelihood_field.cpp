#include "eyebridge/localisation/likelihood_field.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "eyebridge/base/units.hpp"
#include "eyebridge/mapping/distance_field.hpp"

namespace eyebridge::localisation {
namespace {

const BeamSettings& checked_beams(const BeamSettings& settings) {
  const bool good = settings.sigma > 0.0 && std::isfinite(settings.sigma) &&
                    settings.max_range > 0.0 && std::isfinite(settings.max_range) &&
                    settings.z_hit >= 0.0 && settings.z_hit <= 1.0 && settings.z_random > 0.0 &&
                    settings.z_random <= 1.0;
  if (!good) throw std::invalid_argument("likelihood field: settings out of range");
  return settings;
}

}  // namespace

LikelihoodField::LikelihoodField(const mapping::Raster<std::uint8_t>& occupied,
                                 const BeamSettings& settings)
    : geometry_(occupied.geometry),
      cells_per_metre_(1.0 / occupied.geometry.resolution),
      last_column_(occupied.geometry.columns + 1),
      last_row_(occupied.geometry.rows + 1),
      stride_(static_cast<std::uint32_t>(occupied.geometry.columns) + 2) {
  checked_beams(settings);
  if (occupied.cells.empty()) throw std::invalid_argument("likelihood field: the map has no cells");
  const double peak = settings.z_hit / (settings.sigma * std::sqrt(2 * kPi));
  const double chance = settings.z_random / settings.max_range;
  const auto log_density = [&](double distance) {
    const double z = distance / settings.sigma;
    return log_of(peak * exp_of(-0.5 * z * z) + chance);
  };
  highest_ = log_density(0.0);
  table_.assign(stride_ * (static_cast<std::size_t>(geometry_.rows) + 2),
                static_cast<float>(log_of(chance)));
  const mapping::Raster<float> distances = mapping::distance_field(occupied);
  for (int row = 0; row < geometry_.rows; ++row) {
    for (int column = 0; column < geometry_.columns; ++column) {
      const std::size_t place =
          static_cast<std::size_t>(row + 1) * stride_ + static_cast<std::size_t>(column + 1);
      table_[place] = static_cast<float>(log_density(distances[{column, row}]));
    }
  }
}

double LikelihoodField::at(Vec2 point) const {
  const Vec2 place[1] = {point};
  return log_likelihood({}, place);
}

double LikelihoodField::log_likelihood(const Pose& pose, std::span<const Vec2> hits) const {
  const SinCos turn = sin_cos(pose.theta);
  const double s = turn.sin * cells_per_metre_;
  const double c = turn.cos * cells_per_metre_;
  // In cells of the table, whose first one is the border's.
  const double x = (pose.x - geometry_.origin.x) * cells_per_metre_ + 1.0;
  const double y = (pose.y - geometry_.origin.y) * cells_per_metre_ + 1.0;
  const float* const table = table_.data();
  const auto look = [&](Vec2 hit) {
    // Held within the border before the fraction goes: then cutting it off is rounding down. What
    // is no number becomes 0: the first argument of std::max() stays where nothing is greater.
    const double column = std::min(std::max(0.0, x + (c * hit.x - s * hit.y)), last_column_);
    const double row = std::min(std::max(0.0, y + (s * hit.x + c * hit.y)), last_row_);
    return static_cast<double>(
        table[static_cast<std::uint32_t>(static_cast<std::int32_t>(row)) * stride_ +
              static_cast<std::uint32_t>(static_cast<std::int32_t>(column))]);
  };
  // Four sums at once, so that none waits for the last addition.
  double sums[4] = {};
  std::size_t i = 0;
  for (; i + 4 <= hits.size(); i += 4) {
    for (std::size_t k = 0; k < 4; ++k) sums[k] += look(hits[i + k]);
  }
  for (; i < hits.size(); ++i) sums[0] += look(hits[i]);
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

void LikelihoodField::log_likelihoods(const Particles& particles, std::span<const Vec2> hits,
                                      std::span<double> out) const {
  for (std::size_t i = 0; i < particles.size(); ++i) {
    out[i] = log_likelihood(particles.pose(i), hits);
  }
}

}  // namespace eyebridge::localisation
