#include "wall_index.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace eyebridge::world {
namespace {

constexpr std::uint32_t kBare = ~std::uint32_t{0};

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

WallIndex::WallIndex(const std::vector<Wall>& walls) {
  for (const Wall& wall : join_collinear(walls)) {
    const std::vector<Segment> outline = outlines_of({wall});
    const bool bare = wall.thickness <= 0.0;
    const std::uint32_t owner = bare ? kBare : static_cast<std::uint32_t>(thick_.size());
    if (!bare) thick_.push_back(wall);
    segments_.insert(segments_.end(), outline.begin(), outline.end());
    owners_.insert(owners_.end(), outline.size(), owner);
  }
  build_grid();
}

void WallIndex::build_grid() {
  starts_.assign(2, 0);
  if (segments_.empty()) return;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Vec2 low{kInfinity, kInfinity};
  Vec2 high{-kInfinity, -kInfinity};
  double length = 0.0;
  for (const Segment& s : segments_) {
    for (const Vec2 p : {s.a, s.a + s.length * s.u}) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    length += s.length;
  }
  // About as many cells as wall pieces of a cell's length, within bounds.
  const double count = static_cast<double>(segments_.size());
  const double extent = std::max(high.x - low.x, high.y - low.y);
  const double area = std::max((high.x - low.x) * (high.y - low.y), 1e-6 * extent * extent);
  const double cell =
      std::max({area / length * 1.2, std::sqrt(area / (16.0 * count)), extent / 1024});
  origin_ = low;
  per_cell_ = 1.0 / cell;
  columns_ = static_cast<std::size_t>((high.x - low.x) * per_cell_) + 1;
  rows_ = static_cast<std::size_t>((high.y - low.y) * per_cell_) + 1;

  // Two passes: count, then fill. Segments on a border go to both sides.
  const double slack = 1e-7 * cell;
  const auto each_cell_of = [&](const Segment& s, auto visit) {
    const Vec2 end = s.a + s.length * s.u;
    const Range columns =
        columns_of(std::min(s.a.x, end.x) - slack, std::max(s.a.x, end.x) + slack);
    const Range rows = rows_of(std::min(s.a.y, end.y) - slack, std::max(s.a.y, end.y) + slack);
    const Vec2 normal{std::fabs(s.u.y), std::fabs(s.u.x)};
    const double half_width = (cell / 2) * (normal.x + normal.y) + slack;
    for (std::size_t row = rows.first; row <= rows.last; ++row) {
      for (std::size_t column = columns.first; column <= columns.last; ++column) {
        const Vec2 centre = origin_ + cell * Vec2{static_cast<double>(column) + 0.5,
                                                  static_cast<double>(row) + 0.5};
        if (std::fabs(cross(s.u, centre - s.a)) <= half_width) visit(row * columns_ + column);
      }
    }
  };
  starts_.assign(columns_ * rows_ + 1, 0);
  for (const Segment& s : segments_) each_cell_of(s, [&](std::size_t c) { ++starts_[c + 1]; });
  for (std::size_t c = 1; c < starts_.size(); ++c) starts_[c] += starts_[c - 1];
  items_.resize(starts_.back());
  std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
  for (std::uint32_t i = 0; i < segments_.size(); ++i) {
    each_cell_of(segments_[i], [&](std::size_t c) { items_[next[c]++] = i; });
  }
}

bool WallIndex::inside_thick(Vec2 p) const {
  return std::any_of(thick_.begin(), thick_.end(),
                     [&](const Wall& wall) { return within(wall, p); });
}

WallIndex::Contact WallIndex::first_contact(Vec2 from, Vec2 motion, double reach) const {
  Contact best;
  const Vec2 to = from + motion;
  each_in_box({std::min(from.x, to.x) - reach, std::min(from.y, to.y) - reach},
              {std::max(from.x, to.x) + reach, std::max(from.y, to.y) + reach},
              [&](std::uint32_t i) {
                const double fraction = wall_contact(segments_[i], from, motion, reach);
                if (fraction > best.fraction || fraction > 1.0) return;
                // A disc that a person put into a thick wall may leave it on any side.
                if (owners_[i] != kBare && within(thick_[owners_[i]], from)) return;
                if (fraction < best.fraction || i < best.segment) best = {fraction, i};
              });
  return best;
}

double WallIndex::distance(Vec2 p, double limit) const {
  double best = limit;
  each_near(p, limit, [&](std::uint32_t, double d) { best = std::min(best, d); });
  return best;
}

}  // namespace eyebridge::world
