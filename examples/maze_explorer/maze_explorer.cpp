// Maps a maze with four distance sensors, then drives the shortest way from its start to its
// centre.
//
// It knows nothing of the maze but the contest's rules: square cells, and a start in the middle of
// one that has a wall, from which it measures how big a cell is. It goes to the nearest cell that
// it has not visited until there is none, returns to the start and runs to the centre. Told how
// many cells the maze has, it takes the start for a corner; else the centre is that of the cells
// that it could reach. A maze that is open to the outside has no end: it gives up there.
//
// Usage: maze_explorer [distance of the PSDs from the robot's centre in mm, 20 by default
//                       [columns and rows of the maze]]

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include "eyebot++.h"
#include "maze_map.hpp"

namespace {

constexpr int kPsdOf[4] = {PSD_FRONT, PSD_LEFT, PSD_BACK, PSD_RIGHT};  // by turns to the left
constexpr int kSpeed = 400;                                            // mm/s
constexpr int kTurnSpeed = 240;                                        // deg/s
constexpr double kDegrees = 57.29577951308232;                         // in a radian
constexpr int kMostCells = 4096;  // four times the largest contest maze
constexpr int kFarthest = 3000;   // mm: beyond it a range may be "nothing there"
constexpr double kSame = 0.25;    // of a cell: by so much a range may be wrong

class Explorer {
 public:
  Explorer(int psd_offset, int columns, int rows)
      : psd_offset_(psd_offset), columns_(columns), rows_(rows) {}

  int run() {
    LCDMenu("", "", "", "");
    if (!measure_cell()) return 1;
    if (!explore()) return 1;
    if (map_.visited_count() > kMostCells) return gave_up();
    if (map_.visited_count() == 1) return shut_in();
    if (!drive(map_.way(at_, heading_, [](Cell c) { return c == Cell{}; }))) return lost();
    return run_to_centre();
  }

 private:
  /// Range from the robot's centre, `turns` quarter turns to the left of its front.
  int range(int turns) const { return PSDGet(kPsdOf[turns]) + psd_offset_; }

  /// The nearest wall is half a cell away; opposite walls, some cells from each other, say it
  /// better.
  bool measure_cell() {
    const int ranges[4] = {range(0), range(1), range(2), range(3)};
    const int nearest = *std::min_element(ranges, ranges + 4);
    if (nearest > kFarthest / 2) {
      std::printf("the start cell needs a wall: the nearest is %d mm away\n", nearest);
      return false;
    }
    cell_ = 2 * nearest;
    int fewest = 0;
    for (int turns = 0; turns < 2; ++turns) {
      const int between = ranges[turns] + ranges[turns + 2];
      const int cells = static_cast<int>(std::lround(between / (2.0 * nearest)));
      if (between > kFarthest || (fewest > 0 && cells >= fewest)) continue;
      fewest = cells;
      cell_ = between / cells;
    }
    for (const int range : ranges) {
      if (range < kFarthest && !fits(range)) return no_cells(range);
    }
    std::printf("cells of %d mm\n", cell_);
    return true;
  }

  /// Whether a wall can be so far from the middle of a cell. Far away a small error of the cell's
  /// size is a large one of the range.
  bool fits(int range) const {
    const double cells = (range - cell_ / 2.0) / cell_;
    return cells > 4 || std::abs(cells - std::round(cells)) <= kSame;
  }

  bool no_cells(int range) const {
    std::printf("no cells of %d mm: a wall is %d mm from the middle of cell %d, %d\n", cell_, range,
                at_.x, at_.y);
    return false;
  }

  /// Also a second look at the size of the cells: a wall within one means that it is too large.
  bool look_around() {
    if (map_.visited(at_)) return true;
    map_.set_visited(at_);
    for (int turns = 0; turns < 4; ++turns) {
      const int way = range(turns);
      if (way < cell_ && !fits(way)) return no_cells(way);
      map_.set_edge(at_, (heading_ + turns) % 4, way < cell_);
    }
    const int seen = map_.visited_count();
    LCDSetPrintf(0, 0, "cells seen: %d", seen);
    if (seen % 16 == 0) {
      std::printf("%d cells seen after %.1f s\n", seen, OSGetCount() / 1000.0);
      std::fflush(stdout);
    }
    return true;
  }

  /// False: it has said why it cannot go on.
  bool explore() {
    if (!look_around()) return false;
    for (;;) {
      const auto way = map_.way(at_, heading_, [this](Cell c) { return !map_.visited(c); });
      if (way.empty()) return true;
      if (!drive(way)) {
        lost();
        return false;
      }
      if (!look_around()) return false;
      if (map_.visited_count() > kMostCells) return true;
    }
  }

  void turn_to(int direction) {
    const int turns = (direction - heading_ + 4) % 4;
    skew_ -= turns == 3 ? -90 : 90 * turns;  // seen from the new direction
    heading_ = direction;
    aim(0.0);
  }

  /// Turns to `angle` degrees to the left of the direction, as well as whole degrees can.
  void aim(double angle) {
    const int turn = static_cast<int>(std::lround(angle - skew_));
    if (turn == 0) return;
    VWTurn(turn, kTurnSpeed);
    VWWait();
    skew_ += turn;
  }

  /// Millimetres to the left of the cell's middle, where there is a wall to tell.
  std::optional<double> offset() const {
    const int left = range(1);
    const int right = range(3);
    if (left < cell_ && right < cell_) return (right - left) / 2.0;
    if (left < cell_) return cell_ / 2.0 - left;
    if (right < cell_) return right - cell_ / 2.0;
    return std::nullopt;
  }

  /// Drives so many cells, towards their middle. Where walls are beside both ends of the way they
  /// tell how far the robot was turned off it, which odometry alone cannot.
  bool straight(int cells) {
    const int way = cells * cell_;
    const auto before = offset();
    if (before && std::abs(*before) >= 3) aim(std::atan2(-*before, way) * kDegrees);
    VWStraight(way, kSpeed);
    if (VWWait() != 0) return false;
    const auto after = offset();
    if (before && after) skew_ = std::atan2(*after - *before, way) * kDegrees;
    return true;
  }

  bool drive(const std::vector<int>& way) {
    for (std::size_t i = 0; i < way.size();) {
      std::size_t end = i;
      while (end < way.size() && way[end] == way[i]) ++end;
      turn_to(way[i]);
      if (!straight(static_cast<int>(end - i))) return false;
      for (; i < end; ++i) at_ = neighbour(at_, way[i]);
    }
    return true;
  }

  int run_to_centre() {
    const std::vector<Cell> centre = map_.centre(columns_, rows_);
    const auto is_centre = [&](Cell c) {
      for (const Cell& goal : centre) {
        if (map_.visited(c) && c == goal) return true;
      }
      return false;
    };
    const auto way = map_.way(at_, heading_, is_centre);
    draw_map(way);
    const int start = OSGetCount();
    if (way.empty() && !is_centre(at_)) {
      std::printf("the centre cannot be reached\n");
      return 1;
    }
    if (!drive(way) || !is_where_map_says()) return lost();
    std::printf("cells seen: %d\n", map_.visited_count());
    std::printf("path length: %d cells, %d mm\n", static_cast<int>(way.size()),
                static_cast<int>(way.size()) * cell_);
    std::printf("final run: %.2f s\n", (OSGetCount() - start) / 1000.0);
    LCDSetPrintf(1, 0, "path: %d cells", static_cast<int>(way.size()));
    std::printf("maze solved\n");
    return 0;
  }

  /// Whether the walls around are those that the map has here.
  bool is_where_map_says() const {
    for (int turns = 0; turns < 4; ++turns) {
      const bool wall = map_.edge(at_, (heading_ + turns) % 4) == MazeMap::Edge::Wall;
      if (wall != (range(turns) < cell_)) return false;
    }
    return true;
  }

  int shut_in() const {
    std::printf("no way out of the start cell\n");
    return 1;
  }

  int gave_up() const {
    std::printf("gave up: more than %d cells seen; is the maze open to the outside?\n", kMostCells);
    return 1;
  }

  int lost() const {
    std::printf("stuck near cell %d, %d\n", at_.x, at_.y);
    return 1;
  }

  void draw_map(const std::vector<int>& way) const {
    int width = 0;
    int height = 0;
    LCDGetSize(&width, &height);
    const auto [low, high] = map_.extent();
    const int top = 40;
    const int size =
        std::min(width / (high.x - low.x + 2), (height - top - 45) / (high.y - low.y + 2));
    const auto left_of = [&, low = low](Cell c) { return size / 2 + (c.x - low.x) * size; };
    const auto top_of = [&, high = high](Cell c) { return top + (high.y - c.y) * size; };
    for (int y = low.y; y <= high.y; ++y) {
      for (int x = low.x; x <= high.x; ++x)
        draw_cell({x, y}, left_of({x, y}), top_of({x, y}), size);
    }
    Cell cell = at_;
    for (const int direction : way) {
      const Cell next = neighbour(cell, direction);
      LCDLine(left_of(cell) + size / 2, top_of(cell) + size / 2, left_of(next) + size / 2,
              top_of(next) + size / 2, RED);
      cell = next;
    }
  }

  void draw_cell(Cell cell, int x, int y, int size) const {
    const auto wall = [&](int direction) {
      return map_.edge(cell, direction) == MazeMap::Edge::Wall;
    };
    if (wall(kNorth)) LCDLine(x, y, x + size, y, WHITE);
    if (wall(kSouth)) LCDLine(x, y + size, x + size, y + size, WHITE);
    if (wall(kWest)) LCDLine(x, y, x, y + size, WHITE);
    if (wall(kEast)) LCDLine(x + size, y, x + size, y + size, WHITE);
  }

  int psd_offset_;
  int columns_;  // of the maze; 0: nobody has said it
  int rows_;
  int cell_ = 0;
  Cell at_;
  int heading_ = kNorth;
  double skew_ = 0.0;  // degrees that the robot looks to the left of heading_
  MazeMap map_;
};

}  // namespace

int main(int argc, char** argv) {
  const auto number = [&](int i, int usual) { return argc > i ? std::atoi(argv[i]) : usual; };
  return Explorer(number(1, 20), number(2, 0), number(3, number(2, 0))).run();
}
