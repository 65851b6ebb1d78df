#include "eyebridge/localisation/scan.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "eyebridge/base/units.hpp"

namespace eyebridge::localisation {

Scan Scan::thinned(std::size_t count) const {
  Scan out;
  out.origin = origin;
  const std::size_t kept = std::min(count, hits.size());
  out.hits.reserve(kept);
  for (std::size_t i = 0; i < kept; ++i) out.hits.push_back(hits[i * hits.size() / kept]);
  return out;
}

Scan scan_of(std::span<const double> ranges, double field_of_view, const robot::LidarModel& lidar) {
  if (lidar.tilt != 0.0) {
    throw std::invalid_argument("scan: expected a lidar that looks ahead, found a tilted one");
  }
  constexpr double kNearlyAll = 1e-9;  // radians; what a full circle may lack
  const bool circle = field_of_view >= 2 * kPi - kNearlyAll;
  const auto count = static_cast<double>(ranges.size());
  const double gaps = circle ? count : std::max(count - 1, 1.0);
  const double start = ranges.size() > 1 ? field_of_view / 2 : 0.0;
  Scan out;
  out.origin = lidar.pose_in_robot.position();
  out.hits.reserve(ranges.size());
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const double range = ranges[i];
    if (!(range > 0.0)) continue;
    const double bearing = start - static_cast<double>(i) * field_of_view / gaps;
    const Heading heading = Heading::from_angle(lidar.pose_in_robot.theta + bearing);
    const bool miss = range >= lidar.max_range;
    const Vec2 end = out.origin + std::min(range, lidar.max_range) * heading.forward();
    (miss ? out.misses : out.hits).push_back(end);
  }
  return out;
}

Scan scan_of(std::span<const double> ranges, std::span<const robot::RangeSensorModel> sensors) {
  if (ranges.size() != sensors.size()) {
    throw std::invalid_argument("scan: expected as many ranges as sensors");
  }
  Scan out;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const robot::RangeSensorModel& sensor = sensors[i];
    if (!(ranges[i] > 0.0)) continue;
    const bool miss = ranges[i] >= sensor.max_range || ranges[i] == sensor.out_of_range;
    const Vec2 place = sensor.pose_in_robot.position();
    const Vec2 forward = Heading::from_angle(sensor.pose_in_robot.theta).forward();
    (miss ? out.misses : out.hits)
        .push_back(place + std::min(ranges[i], sensor.max_range) * forward);
  }
  return out;
}

mapping::Raster<std::uint8_t> walls_seen(const Scan& scan, double resolution, double gap,
                                         double margin) {
  Vec2 low = scan.origin;
  Vec2 high = scan.origin;
  for (const Vec2 hit : scan.hits) {
    low = {std::min(low.x, hit.x), std::min(low.y, hit.y)};
    high = {std::max(high.x, hit.x), std::max(high.y, hit.y)};
  }
  // A cell more, which rounding may need.
  const double border = margin + resolution;
  mapping::Raster<std::uint8_t> out(
      mapping::GridGeometry::covering(low - Vec2{border, border}, high.x - low.x + 2 * border,
                                      high.y - low.y + 2 * border, resolution));
  for (std::size_t i = 0; i < scan.hits.size(); ++i) {
    const Vec2 from = scan.hits[i];
    const Vec2 way = scan.hits[(i + 1) % scan.hits.size()] - from;
    const double length = norm(way);
    const double steps = length <= gap ? std::ceil(2 * length / resolution) : 0.0;
    for (double k = 0; k <= steps; ++k) {
      out[out.geometry.cell_at(from + (k / std::max(steps, 1.0)) * way)] = 1;
    }
  }
  return out;
}

}  // namespace eyebridge::localisation
