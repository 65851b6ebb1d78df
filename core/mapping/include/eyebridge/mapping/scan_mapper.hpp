#pragma once

#include <memory>
#include <span>

#include "eyebridge/base/pose.hpp"
#include "eyebridge/base/result.hpp"
#include "eyebridge/mapping/beam_model.hpp"
#include "eyebridge/mapping/occupancy_grid.hpp"

namespace eyebridge::mapping {

/// Takes whole scans, or single beams, into grids: the fast way.
///
/// Each cell gets the evidence of a scan once, however many of its beams cross it: the beams of a
/// scan share walls and errors and are no independent witnesses, least of all near the sensor. Of
/// several beams the one counts that speaks most for an obstacle. No logarithm is taken while
/// mapping: they are in a table by standard deviation and distance from the reading. Not
/// thread-safe.
class ScanMapper {
 public:
  /// Throws std::invalid_argument for a model that cannot be.
  explicit ScanMapper(const BeamModel& model);
  ~ScanMapper();
  ScanMapper(ScanMapper&&) noexcept;
  ScanMapper& operator=(ScanMapper&&) noexcept;

  [[nodiscard]] const BeamModel& model() const;

  /// Takes the readings `ranges` of beams along the unit vectors `directions`, all in the world and
  /// from one `origin`; as many of both. Beams that say nothing are passed over. Fails with
  /// OutOfRange, and changes nothing, for an origin that is not finite, a direction that is no unit
  /// vector, and where the grid would need more cells than it may have.
  Result<void> insert(OccupancyGrid& grid, Vec2 origin, std::span<const Vec2> directions,
                      std::span<const double> ranges);
  /// The same map, faster, of directions that are evenly spaced: each is the one before turned by
  /// `gap` radians to either side, not 0, all of them one turn at most.
  Result<void> insert_sweep(OccupancyGrid& grid, Vec2 origin, std::span<const Vec2> directions,
                            double gap, std::span<const double> ranges);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace eyebridge::mapping
