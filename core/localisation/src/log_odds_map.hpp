#pragma once

#include <cstdint>
#include <vector>

#include "eyebridge/localisation/scan.hpp"
#include "eyebridge/mapping/raster.hpp"

namespace eyebridge::localisation {

/// What scans say about the cells of a floor, as log-odds: S. Thrun, W. Burgard and D. Fox,
/// "Probabilistic Robotics" (2005), table 9.1. Each scan counts once for a cell, as met if any of
/// its rays ended there.
class LogOddsMap {
 public:
  /// Evidence of a ray that ended in a cell, > 0, or crossed it, < 0; the sum stays within `limit`.
  LogOddsMap(const mapping::GridGeometry& where, float met, float crossed, float limit);

  /// Takes `scan` of a robot at `pose`. Rays that met nothing are taken to say nothing: a ray that
  /// got lost looks the same. What is outside of the grid is left out.
  void insert(const Pose& pose, const Scan& scan);

  [[nodiscard]] const mapping::Raster<float>& log_odds() const { return log_odds_; }
  /// 1 where the log-odds are above 0.
  [[nodiscard]] mapping::Raster<std::uint8_t> occupied() const;

 private:
  void cross(mapping::Cell from, mapping::Cell to);

  mapping::Raster<float> log_odds_;
  std::vector<std::uint32_t> crossed_in_;  ///< The last scan that crossed each cell.
  std::vector<std::uint32_t> met_in_;
  std::uint32_t scans_ = 0;
  float met_;
  float crossed_;
  float limit_;
};

}  // namespace eyebridge::localisation
