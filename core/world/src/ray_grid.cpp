#include "ray_grid.hpp"

#include <algorithm>
#include <cmath>

namespace eyebridge::world {
namespace {

/// Fewer segments to a cell mean more cells on the way. Flat around the optimum in mazes and in
/// open scenes (bench_ray_casting).
constexpr double kSegmentsPerCell = 1.2;

/// Rays leap only where at least this share of the cells can be leapt from: in mazes and among
/// crowds of walls, looking for such cells makes rays 6 % slower.
constexpr double kEmptyShare = 0.25;

/// For each cell the largest n <= 254 for which no cell up to n columns and n rows away has a
/// segment; 0 where the cell itself has one. By two passes over the grid (Rosenfeld and Pfaltz,
/// "Distance functions on digital pictures", 1968).
std::vector<std::uint8_t> clear_cells(const SegmentGrid& grid) {
  const std::size_t columns = grid.columns();
  const std::size_t rows = grid.rows();
  // How many cells away the nearest segment is; with a ring of cells around that have none.
  const std::size_t stride = columns + 2;
  std::vector<std::uint8_t> away(stride * (rows + 2), 255);
  const auto spread = [&](std::size_t at, std::size_t a, std::size_t b, std::size_t c,
                          std::size_t d) {
    const int nearest = std::min({away[a], away[b], away[c], away[d]});
    away[at] = static_cast<std::uint8_t>(std::min<int>(away[at], std::min(nearest, 254) + 1));
  };
  for (std::size_t row = 1; row <= rows; ++row) {
    for (std::size_t column = 1; column <= columns; ++column) {
      const std::size_t cell = (row - 1) * columns + column - 1;
      const std::size_t at = row * stride + column;
      if (grid.begin_of(cell) != grid.end_of(cell)) away[at] = 0;
      spread(at, at - 1, at - stride - 1, at - stride, at - stride + 1);
    }
  }
  for (std::size_t row = rows; row >= 1; --row) {
    for (std::size_t column = columns; column >= 1; --column) {
      const std::size_t at = row * stride + column;
      spread(at, at + 1, at + stride - 1, at + stride, at + stride + 1);
    }
  }
  std::vector<std::uint8_t> clear(columns * rows);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const int nearest = away[(row + 1) * stride + column + 1];
      clear[row * columns + column] = static_cast<std::uint8_t>(std::max(nearest - 1, 0));
    }
  }
  return clear;
}

}  // namespace

RayGrid::RayGrid(const std::vector<Segment>& segments)
    : grid_(segments, cell_size_for(segments, kSegmentsPerCell), 2) {
  const std::size_t cells = grid_.columns() * grid_.rows();
  starts_.reserve(cells + 1);
  for (std::size_t c = 0; c < cells; ++c) {
    starts_.push_back(static_cast<std::uint32_t>(segments_.size()));
    for (const std::uint32_t* i = grid_.begin_of(c); i != grid_.end_of(c); ++i) {
      segments_.push_back(segments[*i]);
    }
  }
  starts_.push_back(static_cast<std::uint32_t>(segments_.size()));
  clear_ = clear_cells(grid_);
  const auto empty =
      std::ranges::count_if(clear_, [](std::uint8_t clear) { return clear >= RayGroup::kLeap; });
  if (static_cast<double>(empty) < kEmptyShare * static_cast<double>(cells)) clear_ = {};
}

void RayGrid::cast(Vec2 origin, std::span<const Vec2> directions, double max_range,
                   std::span<double> ranges) const {
  RayGroup group;
  for (std::size_t first = 0; first < directions.size(); first += RayGroup::kMost) {
    const std::size_t count = std::min(directions.size() - first, RayGroup::kMost);
    start_rays(origin, directions.subspan(first, count), max_range, group);
    walk(origin, group);
    std::copy_n(group.best, count, ranges.begin() + static_cast<std::ptrdiff_t>(first));
  }
}

void RayGrid::start_rays(Vec2 origin, std::span<const Vec2> directions, double max_range,
                         RayGroup& group) const {
  const std::size_t padded = (directions.size() + 7) / 8 * 8;
  for (std::size_t i = 0; i < padded; ++i) {
    const Vec2 d = directions[i < directions.size() ? i : 0];
    group.dx[i] = d.x;
    group.dy[i] = d.y;
    group.best[i] = max_range;
  }
  const double cell = grid_.cell();
  const double per_cell = 1.0 / cell;
  const double columns = static_cast<double>(grid_.columns());
  const double rows = static_cast<double>(grid_.rows());
  const std::size_t row_step = grid_.columns();
  // The box that rays are clipped to: the outermost ring of cells is empty and takes up what
  // rounding lets a ray go too far. Coordinates are in cells from here on.
  constexpr double kRing = 0.5;
  const Vec2 from = per_cell * (origin - grid_.origin());
  const bool inside =
      from.x > kRing && from.x < columns - kRing && from.y > kRing && from.y < rows - kRing;

  // The same place for all rays that start inside.
  Vec2 in_cell;  // 0 … 1 each, but for rounding
  double entry = 0.0;
  std::size_t at = 0;
  const auto enter_at = [&](Vec2 p) {
    const Vec2 place = grid_.origin() + cell * p;
    const std::size_t column = grid_.column_of(place.x);
    const std::size_t row = grid_.row_of(place.y);
    at = row * grid_.columns() + column;
    in_cell = p - Vec2{static_cast<double>(column), static_cast<double>(row)};
  };
  if (inside) enter_at(from);

  group.left = 0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Vec2 d = directions[i];
    const bool right = d.x >= 0.0;
    const bool up = d.y >= 0.0;
    // Infinite where the ray is parallel to an axis; no crossing is ever nearer then.
    const double cells_x = cell / std::fabs(d.x);
    const double cells_y = cell / std::fabs(d.y);
    const double out_x = (right ? columns - kRing - from.x : from.x - kRing) * cells_x;
    const double out_y = (up ? rows - kRing - from.y : from.y - kRing) * cells_y;
    const double out = out_x < out_y ? out_x : out_y;
    if (!inside) {
      const double gap_x = right ? kRing - from.x : from.x - (columns - kRing);
      const double gap_y = up ? kRing - from.y : from.y - (rows - kRing);
      const double in_x = gap_x > 0.0 ? gap_x * cells_x : 0.0;
      const double in_y = gap_y > 0.0 ? gap_y * cells_y : 0.0;
      entry = in_x > in_y ? in_x : in_y;
      if (!(entry < (out < max_range ? out : max_range))) continue;
      enter_at(from + (entry * per_cell) * d);
    }
    group.active[group.left++] = static_cast<std::uint32_t>(i);
    RayState& state = group.states[i];
    const double part_x = right ? 1.0 - in_cell.x : in_cell.x;
    const double part_y = up ? 1.0 - in_cell.y : in_cell.y;
    state.next[0] = d.x == 0.0 ? kNever : entry + part_x * cells_x;
    state.next[1] = d.y == 0.0 ? kNever : entry + part_y * cells_y;
    state.between[0] = cells_x;
    state.between[1] = cells_y;
    state.limit = out;
    state.cell = at;
    state.step[0] = right ? 1 : std::size_t{0} - 1;
    state.step[1] = up ? row_step : std::size_t{0} - row_step;
  }
}

}  // namespace eyebridge::world
