#include "eyebridge/localisation/grid_slam.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

namespace eyebridge::localisation {

GridSlam::GridSlam(const GridSlamSettings& settings, const Pose& start)
    : settings_(settings),
      map_(settings.geometry, settings.occupancy),
      mapper_(settings.beam),
      pose_(start) {
  if (!(settings.update_distance >= 0.0 && settings.update_turn >= 0.0)) {
    throw std::invalid_argument("grid SLAM: settings out of range");
  }
  // Says now what is wrong with them, not at the second scan.
  (void)ScanMatcher(mapping::Raster<std::uint8_t>(mapping::GridGeometry{{}, 1.0, 1, 1}),
                    settings.match);
}

Result<void> GridSlam::draw(const Scan& scan) {
  const Heading heading = Heading::from_angle(pose_.theta);
  std::vector<Vec2> directions;
  std::vector<double> ranges;
  const auto add_rays = [&](const std::vector<Vec2>& ends, bool met) {
    for (const Vec2 end : ends) {
      const Vec2 ray = end - scan.origin;
      const double range = norm(ray);
      if (!(range > 0.0)) continue;
      directions.push_back(heading.rotate((1.0 / range) * ray));
      ranges.push_back(met ? range : settings_.beam.out_of_range);
    }
  };
  add_rays(scan.hits, true);
  add_rays(scan.misses, false);
  return mapper_.insert(map_, pose_.position() + heading.rotate(scan.origin), directions, ranges);
}

Result<GridSlam::Outcome> GridSlam::add(const Pose& odometry, const Scan& scan) {
  if (!std::isfinite(odometry.x) || !std::isfinite(odometry.y) || !std::isfinite(odometry.theta)) {
    return fail(Errc::OutOfRange, "SLAM: odometry that is not finite");
  }
  const bool first = !odometry_;
  if (!first) pose_ = transform(pose_, relative_to(*odometry_, odometry));
  odometry_ = odometry;
  if (!first) {
    const bool moved = norm(odometry.position() - fitted_.position()) >= settings_.update_distance;
    const bool turned =
        std::abs(wrap_angle(odometry.theta - fitted_.theta)) >= settings_.update_turn;
    if (!moved && !turned) return Outcome::Skipped;
    const std::optional<ScanMatch> match =
        ScanMatcher(occupied(), settings_.match).match(pose_, scan);
    if (!match) {
      ++unmatched_;
      return Outcome::Unmatched;
    }
    pose_ = match->estimate.pose;
    last_match_ = match;
  }
  fitted_ = odometry;
  return draw(scan).map([] { return Outcome::Added; });
}

mapping::Raster<std::uint8_t> GridSlam::occupied() const {
  return cells_in(map_, {mapping::CellState::Occupied});
}

}  // namespace eyebridge::localisation
