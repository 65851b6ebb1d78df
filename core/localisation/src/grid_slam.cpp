#include "eyebridge/localisation/grid_slam.hpp"

#include <cmath>
#include <stdexcept>

#include "log_odds_map.hpp"

namespace eyebridge::localisation {
namespace {

const GridSlamSettings& checked_slam(const GridSlamSettings& s) {
  const bool good = s.geometry.columns > 0 && s.geometry.rows > 0 && s.geometry.resolution > 0.0 &&
                    s.update_distance >= 0.0 && s.update_turn >= 0.0 && s.met > 0.0 &&
                    s.crossed < 0.0 && s.limit > 0.0;
  if (!good) throw std::invalid_argument("grid SLAM: settings out of range");
  return s;
}

}  // namespace

struct GridSlam::Map {
  explicit Map(const GridSlamSettings& s)
      : cells(s.geometry, static_cast<float>(s.met), static_cast<float>(s.crossed),
              static_cast<float>(s.limit)) {}

  LogOddsMap cells;
};

GridSlam::GridSlam(const GridSlamSettings& settings, const Pose& start)
    : settings_(checked_slam(settings)), map_(std::make_unique<Map>(settings)), pose_(start) {
  // Says now what is wrong with them, not at the second scan.
  (void)ScanMatcher(mapping::Raster<std::uint8_t>(mapping::GridGeometry{{}, 1.0, 1, 1}),
                    settings.match);
}

GridSlam::~GridSlam() = default;
GridSlam::GridSlam(GridSlam&&) noexcept = default;
GridSlam& GridSlam::operator=(GridSlam&&) noexcept = default;

GridSlam::Outcome GridSlam::add(const Pose& odometry, const Scan& scan) {
  const bool first = !odometry_;
  if (!first) pose_ = transform(pose_, relative_to(*odometry_, odometry));
  odometry_ = odometry;
  if (!first) {
    const bool moved = norm(odometry.position() - fitted_.position()) >= settings_.update_distance;
    const bool turned =
        std::abs(wrap_angle(odometry.theta - fitted_.theta)) >= settings_.update_turn;
    if (!moved && !turned) return Outcome::Skipped;
    const ScanMatcher matcher(map_->cells.occupied(), settings_.match);
    const std::optional<ScanMatch> match = matcher.match(pose_, scan);
    if (!match) {
      ++unmatched_;
      return Outcome::Unmatched;
    }
    pose_ = match->estimate.pose;
    last_match_ = match;
  }
  fitted_ = odometry;
  map_->cells.insert(pose_, scan);
  return Outcome::Added;
}

const mapping::Raster<float>& GridSlam::log_odds() const { return map_->cells.log_odds(); }

mapping::Raster<std::uint8_t> GridSlam::occupied() const { return map_->cells.occupied(); }

}  // namespace eyebridge::localisation
