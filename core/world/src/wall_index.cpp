#include "wall_index.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace eyebridge::world {
namespace {

/// More cells cost memory, fewer cost tests; flat between 0.5 and 1.5.
constexpr double kWallsPerCell = 1.0;

/// A wall on its line: direction and offset rounded so that walls of one line compare equal.
struct OnLine {
  double ux, uy, offset, thickness;
  double from, to;  ///< Along the line, metres; from < to.
  std::size_t index;

  [[nodiscard]] auto line() const { return std::tie(ux, uy, offset, thickness); }
};

constexpr double kSameLine = 1e-8;  // metres, and sine of an angle

double rounded(double v) { return std::floor(v / kSameLine + 0.5) * kSameLine + 0.0; }

OnLine on_line(const Wall& wall, std::size_t index) {
  Vec2 u = segment_between(wall.a, wall.b).u;
  if (rounded(u.x) < 0 || (rounded(u.x) == 0 && u.y < 0)) u = -1.0 * u;
  const double a = dot(wall.a, u);
  const double b = dot(wall.b, u);
  return {rounded(u.x),   rounded(u.y), rounded(cross(u, wall.a)), wall.thickness, std::min(a, b),
          std::max(a, b), index};
}

/// True when `p` lies in the rectangle of the thick `wall`.
bool within(const Wall& wall, Vec2 p) {
  if (wall.thickness <= 0.0) return false;
  const Segment axis = segment_between(wall.a, wall.b);
  const double along = dot(p - wall.a, axis.u);
  return along >= 0.0 && along <= axis.length &&
         std::fabs(cross(axis.u, p - wall.a)) <= wall.thickness / 2;
}

}  // namespace

std::vector<Wall> join_collinear(const std::vector<Wall>& walls) {
  std::vector<OnLine> pieces;
  pieces.reserve(walls.size());
  for (std::size_t i = 0; i < walls.size(); ++i) pieces.push_back(on_line(walls[i], i));
  std::sort(pieces.begin(), pieces.end(), [](const OnLine& p, const OnLine& q) {
    return std::tuple_cat(p.line(), std::tie(p.from, p.index)) <
           std::tuple_cat(q.line(), std::tie(q.from, q.index));
  });
  std::vector<Wall> joined;
  for (std::size_t i = 0; i < pieces.size();) {
    std::size_t last = i;  // the piece that reaches farthest
    std::size_t next = i + 1;
    while (next < pieces.size() && pieces[next].line() == pieces[i].line() &&
           pieces[next].from <= pieces[last].to + kSameLine) {
      if (pieces[next].to > pieces[last].to) last = next;
      ++next;
    }
    Wall wall = walls[pieces[i].index];
    if (next > i + 1) {
      // The ends keep their exact coordinates.
      const Vec2 u{pieces[i].ux, pieces[i].uy};
      const Wall& low = walls[pieces[i].index];
      const Wall& high = walls[pieces[last].index];
      wall.a = dot(low.a, u) < dot(low.b, u) ? low.a : low.b;
      wall.b = dot(high.a, u) < dot(high.b, u) ? high.b : high.a;
    }
    joined.push_back(wall);
    i = next;
  }
  return joined;
}

WallIndex::WallIndex(const std::vector<Wall>& walls)
    : joined_(join_collinear(walls)),
      segments_(outlines_of(joined_)),
      grid_(segments_, cell_size_for(segments_, kWallsPerCell), 0),
      axes_({}, 1.0, 0) {
  std::vector<Segment> axes;
  for (std::uint32_t i = 0; i < joined_.size(); ++i) {
    const bool thick = joined_[i].thickness > 0.0;
    owners_.insert(owners_.end(), thick ? 4 : 1, i);
    if (!thick) continue;
    thick_.push_back(i);
    thickest_ = std::max(thickest_, joined_[i].thickness);
    axes.push_back(segment_between(joined_[i].a, joined_[i].b));
  }
  axes_ = SegmentGrid(axes, cell_size_for(axes, kWallsPerCell), 0);
}

bool WallIndex::inside_thick(Vec2 p) const {
  if (thick_.empty()) return false;
  bool inside = false;
  // Half of it would do, but for rounding.
  axes_.each_in_box(p - Vec2{thickest_, thickest_}, p + Vec2{thickest_, thickest_},
                    [&](std::uint32_t i) { inside = inside || within(joined_[thick_[i]], p); });
  return inside;
}

WallIndex::Approach WallIndex::approach(Vec2 from, Vec2 motion, double length, double reach,
                                        double horizon) const {
  Approach result;
  double nearest = horizon * horizon;
  const double farthest = (reach + length) * (reach + length) * (1.0 + 1e-12);
  const auto meet = [&](std::uint32_t i) {
    const double d = norm_squared(from - closest_point(segments_[i], from));
    if (d < nearest) nearest = d;
    if (d > farthest) return;
    const double fraction = wall_contact(segments_[i], from, motion, reach);
    if (fraction > 1.0 || fraction > result.fraction) return;
    // A disc that a person put into a thick wall may leave it on any side.
    if (within(joined_[owners_[i]], from)) return;
    if (fraction < result.fraction || i < result.segment) {
      result.fraction = fraction;
      result.segment = i;
    }
  };
  grid_.each_in_box({from.x - horizon, from.y - horizon}, {from.x + horizon, from.y + horizon},
                    meet);
  result.distance = std::sqrt(nearest);
  return result;
}

double WallIndex::distance(Vec2 p, double limit) const {
  double best = limit;
  each_near(p, limit, [&](std::uint32_t, double d) { best = std::min(best, d); });
  return best;
}

}  // namespace eyebridge::world
