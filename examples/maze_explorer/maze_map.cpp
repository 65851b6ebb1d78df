#include "maze_map.hpp"

#include <algorithm>
#include <cmath>

namespace {

constexpr int kStep[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
constexpr int kFar = 1 << 30;

}  // namespace

Cell neighbour(Cell cell, int direction) {
  return {cell.x + kStep[direction][0], cell.y + kStep[direction][1]};
}

std::size_t MazeMap::index(Cell cell) {
  return static_cast<std::size_t>((cell.y + kHalf) * kSide + cell.x + kHalf);
}

bool MazeMap::inside(Cell cell) { return std::abs(cell.x) <= kHalf && std::abs(cell.y) <= kHalf; }

void MazeMap::set_edge(Cell cell, int direction, bool wall) {
  const Edge edge = wall ? Edge::Wall : Edge::Open;
  edges_[index(cell)][static_cast<std::size_t>(direction)] = edge;
  const Cell other = neighbour(cell, direction);
  if (inside(other)) edges_[index(other)][static_cast<std::size_t>((direction + 2) % 4)] = edge;
}

MazeMap::Edge MazeMap::edge(Cell cell, int direction) const {
  return edges_[index(cell)][static_cast<std::size_t>(direction)];
}

void MazeMap::set_visited(Cell cell) {
  if (visited_[index(cell)] != 0) return;
  visited_[index(cell)] = 1;
  ++visited_count_;
  low_ = {std::min(low_.x, cell.x), std::min(low_.y, cell.y)};
  high_ = {std::max(high_.x, cell.x), std::max(high_.y, cell.y)};
}

bool MazeMap::visited(Cell cell) const { return inside(cell) && visited_[index(cell)] != 0; }

std::vector<Cell> MazeMap::open_neighbours(Cell cell) const {
  std::vector<Cell> out;
  for (int direction = 0; direction < 4; ++direction) {
    const Cell next = neighbour(cell, direction);
    if (edge(cell, direction) == Edge::Open && inside(next)) out.push_back(next);
  }
  return out;
}

std::vector<int> MazeMap::distances(Cell to, Cell from) const {
  std::vector<int> distance(edges_.size(), kFar);
  distance[index(to)] = 0;
  std::vector<Cell> queue{to};
  for (std::size_t head = 0; head < queue.size() && !(queue[head] == from); ++head) {
    for (const Cell& next : open_neighbours(queue[head])) {
      if (distance[index(next)] != kFar) continue;
      distance[index(next)] = distance[index(queue[head])] + 1;
      queue.push_back(next);
    }
  }
  return distance;
}

std::vector<int> MazeMap::way_to(Cell from, int heading, Cell to) const {
  const std::vector<int> distance = distances(to, from);
  std::vector<int> way;
  for (Cell cell = from; !(cell == to);) {
    int best = -1;
    // Straight on first, then left, right, back: fewer turns among ways of equal length.
    for (const int turn : {0, 1, 3, 2}) {
      const int direction = (heading + turn) % 4;
      if (edge(cell, direction) != Edge::Open) continue;
      const Cell next = neighbour(cell, direction);
      if (inside(next) && distance[index(next)] == distance[index(cell)] - 1) {
        best = direction;
        break;
      }
    }
    if (best < 0) return {};
    way.push_back(best);
    cell = neighbour(cell, best);
    heading = best;
  }
  return way;
}

std::vector<Cell> MazeMap::centre(int columns, int rows) const {
  std::vector<Cell> cells;
  const int width = columns > 0 ? columns : high_.x - low_.x + 1;
  const int height = rows > 0 ? rows : high_.y - low_.y + 1;
  // Cells may lie beyond those that can be reached: away from the start, which is a corner.
  const int left = low_.x < 0 ? high_.x - width + 1 : low_.x;
  const int bottom = low_.y < 0 ? high_.y - height + 1 : low_.y;
  for (int y = (height - 1) / 2; y <= height / 2; ++y) {
    for (int x = (width - 1) / 2; x <= width / 2; ++x) cells.push_back({left + x, bottom + y});
  }
  return cells;
}
