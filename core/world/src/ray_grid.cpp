#include "ray_grid.hpp"

#include <cmath>

namespace eyebridge::world {
namespace {

/// Fewer segments to a cell mean more cells on the way. Flat around the optimum in mazes and in
/// open scenes (bench_ray_casting).
constexpr double kSegmentsPerCell = 1.6;

/// Rounding of single precision, times the number of roundings on the way to a comparison, with
/// something to spare: of coordinates up to the grid's size, metres per metre.
constexpr double kFloatMargin = 2e-6;

unsigned candidates_in(const RayBlock& block, const RayQuery& q, float reach) {
  unsigned lanes = 0;
  for (std::size_t i = 0; i < RayBlock::kLanes; ++i) {
    const float wx = block.ax[i] - q.x;
    const float wy = block.ay[i] - q.y;
    const float den = q.dx * block.uy[i] - q.dy * block.ux[i];
    const float along_ray = wx * block.uy[i] - wy * block.ux[i];
    const float along_wall = wx * q.dy - wy * q.dx;
    const bool flip = std::signbit(den);
    const float size = flip ? -den : den;
    const float r = flip ? -along_ray : along_ray;
    const float w = flip ? -along_wall : along_wall;
    const bool hit = (r >= -q.margin) & (r <= reach * size + q.margin) & (w >= -q.margin) &
                     (w <= block.length[i] * size + q.margin);
    lanes |= static_cast<unsigned>(hit) << i;
  }
  return lanes;
}

}  // namespace

RayGrid::RayGrid(const std::vector<Segment>& segments)
    : segments_(segments), grid_(segments, cell_size_for(segments, kSegmentsPerCell), 2) {
  cells_.resize(grid_.columns() * grid_.rows());
  size_ = grid_.cell() * std::sqrt(static_cast<double>(grid_.columns() * grid_.columns() +
                                                       grid_.rows() * grid_.rows()));
  margin_ = static_cast<float>(kFloatMargin * size_ + kRayTolerance);
  RayBlock unused;
  for (std::size_t i = 0; i < RayBlock::kLanes; ++i) {
    unused.ax[i] = unused.ay[i] = unused.ux[i] = unused.uy[i] = unused.length[i] =
        std::numeric_limits<float>::quiet_NaN();
    unused.segment[i] = 0;
  }
  blocks_.push_back(unused);
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    if (grid_.begin_of(c) == grid_.end_of(c)) continue;  // shares block 0
    cells_[c] = {static_cast<std::uint32_t>(blocks_.size()), 0};
    std::size_t lane = RayBlock::kLanes;
    for (const std::uint32_t* i = grid_.begin_of(c); i != grid_.end_of(c); ++i) {
      if (lane == RayBlock::kLanes) {
        blocks_.push_back(unused);
        ++cells_[c].count;
        lane = 0;
      }
      const Segment& s = segments[*i];
      RayBlock& block = blocks_.back();
      block.ax[lane] = static_cast<float>(s.a.x - grid_.origin().x);
      block.ay[lane] = static_cast<float>(s.a.y - grid_.origin().y);
      block.ux[lane] = static_cast<float>(s.u.x);
      block.uy[lane] = static_cast<float>(s.u.y);
      block.length[lane] = static_cast<float>(s.length);
      block.segment[lane] = *i;
      ++lane;
    }
  }
}

void RayGrid::start_rays(Vec2 origin, std::span<const Vec2> directions, double max_range,
                         RayStart* starts) const {
  const double cell = grid_.cell();
  const double per_cell = 1.0 / cell;
  const double columns = static_cast<double>(grid_.columns());
  const double rows = static_cast<double>(grid_.rows());
  // The box that rays are clipped to: the outermost ring of cells is empty and takes up what
  // rounding lets a ray go too far. Coordinates are in cells from here on.
  constexpr double kRing = 0.5;
  const Vec2 from = per_cell * (origin - grid_.origin());
  const bool inside =
      from.x > kRing && from.x < columns - kRing && from.y > kRing && from.y < rows - kRing;

  // The same place for all rays that start inside.
  Vec2 in_cell;  // 0 … 1 each, but for rounding
  RayStart enter{};
  const auto enter_at = [&](Vec2 p) {
    const Vec2 place = grid_.origin() + cell * p;
    const std::size_t column = grid_.column_of(place.x);
    const std::size_t row = grid_.row_of(place.y);
    enter.cell = static_cast<std::ptrdiff_t>(row * grid_.columns() + column);
    enter.x = static_cast<float>(p.x * cell);
    enter.y = static_cast<float>(p.y * cell);
    in_cell = p - Vec2{static_cast<double>(column), static_cast<double>(row)};
  };
  if (inside) enter_at(from);

  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Vec2 d = directions[i];
    const bool right = d.x >= 0.0;
    const bool up = d.y >= 0.0;
    RayStart& start = starts[i];
    // Infinite where the ray is parallel to an axis; no crossing is ever nearer then.
    const double cells_x = cell / std::fabs(d.x);
    const double cells_y = cell / std::fabs(d.y);
    const double out_x = (right ? columns - kRing - from.x : from.x - kRing) * cells_x;
    const double out_y = (up ? rows - kRing - from.y : from.y - kRing) * cells_y;
    const double out = out_x < out_y ? out_x : out_y;
    const double limit = out < max_range ? out : max_range;
    if (!inside) {
      const double gap_x = right ? kRing - from.x : from.x - (columns - kRing);
      const double gap_y = up ? kRing - from.y : from.y - (rows - kRing);
      const double in_x = gap_x > 0.0 ? gap_x * cells_x : 0.0;
      const double in_y = gap_y > 0.0 ? gap_y * cells_y : 0.0;
      enter.entry = in_x > in_y ? in_x : in_y;
      if (!(enter.entry < limit)) {
        start = {0, 0, kNever, kNever, 0, max_range, 0, 0, 0};
        continue;
      }
      enter_at(from + (enter.entry * per_cell) * d);
    }
    start = enter;
    start.cells_x = cells_x;
    start.cells_y = cells_y;
    start.limit = limit;
    const double part_x = right ? 1.0 - in_cell.x : in_cell.x;
    const double part_y = up ? 1.0 - in_cell.y : in_cell.y;
    start.next_x = d.x == 0.0 ? kNever : enter.entry + part_x * cells_x;
    start.next_y = d.y == 0.0 ? kNever : enter.entry + part_y * cells_y;
  }
}

#define EYEBRIDGE_RAY_TARGET
#define EYEBRIDGE_RAY_CAST cast_scalar
#include "ray_walk.ipp"

}  // namespace eyebridge::world
