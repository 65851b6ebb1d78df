#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "eyebridge/base/units.hpp"
#include "eyebridge/localisation/pose_estimate.hpp"
#include "eyebridge/localisation/scan.hpp"
#include "eyebridge/mapping/raster.hpp"

namespace eyebridge::localisation {

/// Settings of a ScanMatcher.
struct MatchSettings {
  double window = 0.25;                 ///< How far off a guess may be along x and y, metres, > 0.
  double turn_window = deg_to_rad(20);  ///< Likewise its heading, radians, > 0, at most pi.
  double sigma = 0.05;                  ///< What fits within this distance counts, metres, > 0.
  double least_score = 0.4;             ///< 0 … 1: less is no match.
  int block = 4;    ///< Shifts to a side that the search bounds at once; 1: all of them.
  int rounds = 20;  ///< Of the refinement, at most, >= 0.
};

/// Where a scan fits.
struct ScanMatch {
  /// Where the robot is. Deviations of directions that the scan does not settle, along a corridor
  /// say, are those of the window searched.
  PoseEstimate estimate;
  double score = 0.0;  ///< Mean over the hits of exp(-d^2 / (2 sigma^2)), d to the nearest wall.
};

/// Fits scans into a map: where was the robot, near a guess?
///
/// First a search of all poses of a window, cell by cell, that cannot end in a local maximum:
/// E. Olson, "Real-Time Correlative Scan Matching", ICRA 2009; blocks of shifts are ruled out by
/// upper bounds, from a table of the best score that any cell of a block gives, as in W. Hess, D.
/// Kohler, H. Rapp and D. Andor, "Real-Time Loop Closure in 2D LIDAR SLAM", ICRA 2016. Then the
/// pose is refined between cells by Gauss-Newton steps on the interpolated distance to the nearest
/// wall, outliers weighed down (A. Fitzgibbon, "Robust registration of 2D and 3D point sets", Image
/// and Vision Computing 21 (2003) 1145; interpolation as in S. Kohlbrecher, O. von Stryk, J. Meyer
/// and U. Klingauf, "A flexible and scalable SLAM system", SSRR 2011). The covariance is that of
/// these least squares, from their residuals; the map counts as exact. Same calls, same bits.
/// Immutable; any thread.
class ScanMatcher {
 public:
  /// On a map in which `occupied` != 0 is what beams meet; one without any matches nothing. Throws
  /// std::invalid_argument for settings out of range.
  ScanMatcher(const mapping::Raster<std::uint8_t>& occupied, const MatchSettings& settings);

  /// The pose near `guess` from which `scan` was taken; search(), then refined(). Nothing when it
  /// fits nowhere in the window, or has no hits.
  [[nodiscard]] std::optional<ScanMatch> match(const Pose& guess, const Scan& scan) const;

  /// The best of all poses of the window that are whole cells away from `guess`, and turned by
  /// steps that move the farthest hit by a cell.
  [[nodiscard]] Pose search(const Pose& guess, const Scan& scan) const;
  /// The nearest best fit to `pose`.
  [[nodiscard]] ScanMatch refined(const Pose& pose, const Scan& scan) const;

 private:
  [[nodiscard]] std::vector<std::int32_t> places_of(const Pose& pose, const Scan& scan) const;

  mapping::Raster<float> distances_;
  MatchSettings settings_;
  int shifts_;                ///< Cells of the window to each side.
  int padding_;               ///< Cells about the map in the tables below.
  std::int32_t stride_;       ///< Of a row of them.
  std::vector<float> score_;  ///< Of a hit in each cell.
  std::vector<float> bound_;  ///< The best of the block of cells to the right and above.
};

}  // namespace eyebridge::localisation
