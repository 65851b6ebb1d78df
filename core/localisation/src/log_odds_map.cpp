#include "log_odds_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace eyebridge::localisation {

LogOddsMap::LogOddsMap(const mapping::GridGeometry& where, float met, float crossed, float limit)
    : log_odds_(where),
      crossed_in_(where.size(), 0),
      met_in_(where.size(), 0),
      met_(met),
      crossed_(crossed),
      limit_(limit) {}

void LogOddsMap::cross(mapping::Cell from, mapping::Cell to) {
  // J. E. Bresenham, "Algorithm for computer control of a digital plotter", IBM Systems Journal 4
  // (1965) 25, for all directions at once.
  const int dx = std::abs(to.column - from.column);
  const int dy = -std::abs(to.row - from.row);
  const int step_x = from.column < to.column ? 1 : -1;
  const int step_y = from.row < to.row ? 1 : -1;
  int error = dx + dy;
  for (mapping::Cell at = from; at != to;) {
    if (log_odds_.geometry.contains(at)) crossed_in_[log_odds_.geometry.index_of(at)] = scans_;
    const int doubled = 2 * error;
    if (doubled >= dy) {
      error += dy;
      at.column += step_x;
    }
    if (doubled <= dx) {
      error += dx;
      at.row += step_y;
    }
  }
}

void LogOddsMap::insert(const Pose& pose, const Scan& scan) {
  ++scans_;
  const mapping::GridGeometry& where = log_odds_.geometry;
  const Heading heading = Heading::from_angle(pose.theta);
  const auto cell_of = [&](Vec2 point) {
    return where.cell_at(pose.position() + heading.rotate(point));
  };
  const mapping::Cell origin = cell_of(scan.origin);
  for (const Vec2 hit : scan.hits) {
    const mapping::Cell end = cell_of(hit);
    cross(origin, end);
    if (where.contains(end)) met_in_[where.index_of(end)] = scans_;
  }
  for (std::size_t i = 0; i < met_in_.size(); ++i) {
    const bool met = met_in_[i] == scans_;
    if (!met && crossed_in_[i] != scans_) continue;
    float& value = log_odds_.cells[i];
    value = std::clamp(value + (met ? met_ : crossed_), -limit_, limit_);
  }
}

mapping::Raster<std::uint8_t> LogOddsMap::occupied() const {
  mapping::Raster<std::uint8_t> out(log_odds_.geometry);
  for (std::size_t i = 0; i < out.cells.size(); ++i) out.cells[i] = log_odds_.cells[i] > 0 ? 1 : 0;
  return out;
}

}  // namespace eyebridge::localisation
