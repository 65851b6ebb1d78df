#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "eyebridge/base/result.hpp"
#include "eyebridge/localisation/scan_matcher.hpp"
#include "eyebridge/mapping/beam_model.hpp"
#include "eyebridge/mapping/occupancy_grid.hpp"
#include "eyebridge/mapping/scan_mapper.hpp"

namespace eyebridge::localisation {

/// Settings of a GridSlam.
struct GridSlamSettings {
  mapping::GridGeometry geometry;  ///< Of the map as it begins; with `growing` it may get larger.
  mapping::OccupancySettings occupancy;  ///< Of its cells.
  mapping::BeamModel beam;               ///< How the scanner's rays err: beam_model_of(lidar).
  /// How scans are fitted; a scan that sees much that is new fits less than one that does not.
  MatchSettings match{.window = 0.15, .turn_window = deg_to_rad(15), .least_score = 0.25};
  double update_distance = 0.08;       ///< Metres driven between scans that count, >= 0.
  double update_turn = deg_to_rad(8);  ///< Or radians turned, >= 0.
};

/// Draws a map of a floor that nobody knows while finding out where the robot is on it.
///
/// Each scan is fitted into the map that the scans before it made, from where odometry says that
/// the robot went, and then added to it: S. Kohlbrecher, O. von Stryk, J. Meyer and U. Klingauf, "A
/// flexible and scalable SLAM system with full 3D motion estimation", SSRR 2011, with the matcher
/// of scan_matcher.hpp. No loops are closed: what is fitted is never moved again, so that errors
/// grow with the way through floor not seen before, not with the way through what is on the map.
/// Walls are where the middles of their cells are: a map of walls between cells is off by up to
/// half a cell.
/// Same calls, same bits. Not thread-safe.
class GridSlam {
 public:
  /// `start` is where the robot is on the map, by definition. Throws std::invalid_argument for
  /// settings out of range, a geometry without cells and a beam model that cannot be.
  GridSlam(const GridSlamSettings& settings, const Pose& start);

  /// What became of a scan.
  enum class Outcome {
    Skipped,    ///< The robot has hardly moved since the last one: it only moved the pose.
    Added,      ///< Fitted, and added to the map.
    Unmatched,  ///< It fits nowhere near: left out; the pose goes by odometry alone.
  };
  /// The robot saw `scan` where its odometry was at `odometry`. The first scan is added as it is.
  /// Fails with OutOfRange when a map that grows would need more cells than it may have: the scan
  /// is not on it, the pose is right all the same.
  Result<Outcome> add(const Pose& odometry, const Scan& scan);

  /// Where the robot is, on the map: the last fit, and odometry since.
  [[nodiscard]] const Pose& pose() const { return pose_; }
  /// How the last scan that was added fitted; nothing before the second one.
  [[nodiscard]] const std::optional<ScanMatch>& last_match() const { return last_match_; }
  [[nodiscard]] const mapping::OccupancyGrid& map() const { return map_; }
  /// 1 where the map holds a cell for occupied, else 0: what scans are fitted into.
  [[nodiscard]] mapping::Raster<std::uint8_t> occupied() const;
  /// How many scans fitted nowhere.
  [[nodiscard]] std::size_t unmatched() const { return unmatched_; }

 private:
  [[nodiscard]] Result<void> draw(const Scan& scan);

  GridSlamSettings settings_;
  mapping::OccupancyGrid map_;
  mapping::ScanMapper mapper_;
  Pose pose_;
  std::optional<Pose> odometry_;  ///< Where pose_ was.
  Pose fitted_;                   ///< Odometry's pose at the last scan that counted.
  std::optional<ScanMatch> last_match_;
  std::size_t unmatched_ = 0;
};

}  // namespace eyebridge::localisation
