#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "eyebridge/localisation/scan_matcher.hpp"
#include "eyebridge/mapping/raster.hpp"

namespace eyebridge::localisation {

/// Settings of a GridSlam.
struct GridSlamSettings {
  mapping::GridGeometry geometry;  ///< Of the map; what lies outside is not drawn.
  /// How scans are fitted; a scan that sees much that is new fits less than one that does not.
  MatchSettings match{.window = 0.15, .turn_window = deg_to_rad(15), .least_score = 0.25};
  double update_distance = 0.08;       ///< Metres driven between scans that count, >= 0.
  double update_turn = deg_to_rad(8);  ///< Or radians turned, >= 0.
  double met = 0.85;                   ///< Log-odds of a cell that a ray ended in, > 0.
  double crossed = -0.4;               ///< Log-odds of one that a ray went through, < 0.
  double limit = 5.0;                  ///< Log-odds stay within -limit … limit, > 0.
};

/// Draws a map of a floor that nobody knows while finding out where the robot is on it.
///
/// Each scan is fitted into the map that the scans before it made, from where odometry says that
/// the robot went, and then added to it: S. Kohlbrecher, O. von Stryk, J. Meyer and U. Klingauf, "A
/// flexible and scalable SLAM system with full 3D motion estimation", SSRR 2011, with the matcher
/// of scan_matcher.hpp. No loops are closed: what is fitted is never moved again, so that errors
/// grow with the way through floor not seen before, not with the way through what is on the map.
/// Same calls, same bits. Not thread-safe.
class GridSlam {
 public:
  /// `start` is where the robot is on the map, by definition. Throws std::invalid_argument for
  /// settings out of range and a geometry without cells.
  GridSlam(const GridSlamSettings& settings, const Pose& start);
  ~GridSlam();
  GridSlam(GridSlam&&) noexcept;
  GridSlam& operator=(GridSlam&&) noexcept;

  /// What became of a scan.
  enum class Outcome {
    Skipped,    ///< The robot has hardly moved since the last one: it only moved the pose.
    Added,      ///< Fitted, and added to the map.
    Unmatched,  ///< It fits nowhere near: left out; the pose goes by odometry alone.
  };
  /// The robot saw `scan` where its odometry was at `odometry`. The first scan is added as it is.
  Outcome add(const Pose& odometry, const Scan& scan);

  /// Where the robot is, on the map: the last fit, and odometry since.
  [[nodiscard]] const Pose& pose() const { return pose_; }
  /// How the last scan that was added fitted; nothing before the second one.
  [[nodiscard]] const std::optional<ScanMatch>& last_match() const { return last_match_; }
  /// Log-odds of each cell to be occupied; 0 where nothing is known.
  [[nodiscard]] const mapping::Raster<float>& log_odds() const;
  /// 1 where a cell is rather occupied than not, else 0.
  [[nodiscard]] mapping::Raster<std::uint8_t> occupied() const;
  /// How many scans fitted nowhere.
  [[nodiscard]] std::size_t unmatched() const { return unmatched_; }

 private:
  struct Map;

  GridSlamSettings settings_;
  std::unique_ptr<Map> map_;
  Pose pose_;
  std::optional<Pose> odometry_;  ///< Where pose_ was.
  Pose fitted_;                   ///< Odometry's pose at the last scan that counted.
  std::optional<ScanMatch> last_match_;
  std::size_t unmatched_ = 0;
};

}  // namespace eyebridge::localisation
