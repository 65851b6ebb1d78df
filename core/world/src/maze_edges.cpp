#include "maze_edges.hpp"

#include <cmath>

#include "geometry.hpp"
#include "ray_query.hpp"

namespace eyebridge::world {

MazeEdges::MazeEdges(const MazeGrid& maze)
    : cell_(maze.cell),
      columns_(static_cast<std::size_t>(maze.columns) + 2),
      rows_(static_cast<std::size_t>(maze.rows) + 2),
      sides_(columns_ * rows_, 0) {
  const auto mark = [&](std::size_t at, Side side) {
    sides_[at] = static_cast<std::uint8_t>(sides_[at] | side);
  };
  const std::size_t width = columns_ - 2;
  const std::size_t height = rows_ - 2;
  for (std::size_t row = 0; row <= height; ++row) {
    for (std::size_t column = 0; column < width; ++column) {
      if (maze.south[row * width + column] == 0) continue;
      const std::size_t above = (row + 1) * columns_ + column + 1;
      mark(above, kSouth);
      mark(above - columns_, kNorth);
    }
  }
  for (std::size_t row = 0; row < height; ++row) {
    for (std::size_t column = 0; column <= width; ++column) {
      if (maze.west[row * (width + 1) + column] == 0) continue;
      const std::size_t right = (row + 1) * columns_ + column + 1;
      mark(right, kWest);
      mark(right - 1, kEast);
    }
  }
}

bool MazeEdges::describes(const WorldModel& model) {
  if (!model.maze) return false;
  const std::vector<Wall> edges = walls_of(*model.maze);
  if (edges.size() != model.walls.size()) return false;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Wall& wall = model.walls[i];
    if (wall.a != edges[i].a || wall.b != edges[i].b || wall.thickness > 0.0) return false;
  }
  return true;
}

bool MazeEdges::on_line(Vec2 point) const {
  const auto near_line = [&](double v) {
    return std::fabs(v - cell_ * std::floor(v / cell_ + 0.5)) <= kRayTolerance;
  };
  return near_line(point.x) || near_line(point.y);
}

void MazeEdges::cast(Vec2 origin, std::span<const Vec2> directions, double max_range,
                     std::span<double> ranges) const {
  // In cells from the corner of the ring. Half of the ring lies in the box that rays are clipped
  // to; the other half takes up what rounding lets a ray go too far.
  const double columns = static_cast<double>(columns_);
  const double rows = static_cast<double>(rows_);
  const Vec2 start{origin.x / cell_ + 1.0, origin.y / cell_ + 1.0};
  const bool inside =
      start.x > 0.5 && start.x < columns - 0.5 && start.y > 0.5 && start.y < rows - 0.5;
  const auto index_of = [](double v, double count) {
    return v > 0.0 ? (v < count ? static_cast<std::size_t>(v) : static_cast<std::size_t>(count) - 1)
                   : 0;
  };

  for (std::size_t ray = 0; ray < directions.size(); ++ray) {
    const Vec2 d = directions[ray];
    const bool right = d.x >= 0.0;
    const bool up = d.y >= 0.0;
    const double cells_x = cell_ / std::fabs(d.x);
    const double cells_y = cell_ / std::fabs(d.y);
    double entry = 0.0;
    Vec2 p = start;
    const double out_x = (right ? columns - 0.5 - start.x : start.x - 0.5) * cells_x;
    const double out_y = (up ? rows - 0.5 - start.y : start.y - 0.5) * cells_y;
    double limit = out_x < out_y ? out_x : out_y;
    ranges[ray] = max_range;
    if (!inside) {
      const double gap_x = right ? 0.5 - start.x : start.x - (columns - 0.5);
      const double gap_y = up ? 0.5 - start.y : start.y - (rows - 0.5);
      const double in_x = gap_x > 0.0 ? gap_x * cells_x : 0.0;
      const double in_y = gap_y > 0.0 ? gap_y * cells_y : 0.0;
      entry = in_x > in_y ? in_x : in_y;
      if (!(entry < limit)) continue;
      p = {start.x + entry / cell_ * d.x, start.y + entry / cell_ * d.y};
    }
    if (max_range < limit) limit = max_range;

    const std::size_t column = index_of(p.x, columns);
    const std::size_t row = index_of(p.y, rows);
    const double fraction_x = start.x - static_cast<double>(column);
    const double fraction_y = start.y - static_cast<double>(row);
    double next_x = d.x == 0.0 ? kNever : (right ? 1.0 - fraction_x : fraction_x) * cells_x;
    double next_y = d.y == 0.0 ? kNever : (up ? 1.0 - fraction_y : fraction_y) * cells_y;
    const std::ptrdiff_t step_x = right ? 1 : -1;
    const std::ptrdiff_t step_y =
        up ? static_cast<std::ptrdiff_t>(columns_) : -static_cast<std::ptrdiff_t>(columns_);
    const unsigned side_x = right ? kEast : kWest;
    const unsigned side_y = up ? kNorth : kSouth;
    const std::uint8_t* at = sides_.data() + row * columns_ + column;

    for (;;) {
      const double lead = next_x - next_y;
      if (std::fabs(lead) <= kRayTolerance) {
        // Through a corner: any wall that ends there stops the ray, as it has no gap to its
        // neighbour.
        if (!(next_x < limit)) break;
        const unsigned walls = ((at[0] | at[step_y]) & side_x) | ((at[0] | at[step_x]) & side_y);
        if (walls != 0) {
          ranges[ray] = next_x;
          break;
        }
        at += step_x + step_y;
        next_x += cells_x;
        next_y += cells_y;
      } else if (lead < 0.0) {
        if (!(next_x < limit)) break;
        if ((*at & side_x) != 0) {
          ranges[ray] = next_x;
          break;
        }
        at += step_x;
        next_x += cells_x;
      } else {
        if (!(next_y < limit)) break;
        if ((*at & side_y) != 0) {
          ranges[ray] = next_y;
          break;
        }
        at += step_y;
        next_y += cells_y;
      }
    }
  }
}

}  // namespace eyebridge::world
