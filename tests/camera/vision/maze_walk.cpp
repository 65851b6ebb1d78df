#include "maze_walk.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

#include "eyebridge/base/units.hpp"

namespace eyebridge::camera::testing {
namespace {

constexpr double kStep = 0.005;  // metres

/// Cells from `from` to the farthest one.
std::vector<int> longest_way(const world::MazeGrid& maze, int from) {
  const auto open = [&](int cell, int direction) {
    const int column = cell % maze.columns;
    const int row = cell / maze.columns;
    const auto south = [&](int r) {
      return maze.south[static_cast<std::size_t>(r * maze.columns + column)] == 0;
    };
    const auto west = [&](int c) {
      return maze.west[static_cast<std::size_t>(row * (maze.columns + 1) + c)] == 0;
    };
    switch (direction) {
      case 0:
        return west(column + 1);
      case 1:
        return south(row + 1);
      case 2:
        return west(column);
      default:
        return south(row);
    }
  };
  const int steps[4] = {1, maze.columns, -1, -maze.columns};
  std::vector<int> before(static_cast<std::size_t>(maze.columns * maze.rows), -1);
  std::queue<int> queue;
  queue.push(from);
  before[static_cast<std::size_t>(from)] = from;
  int last = from;
  while (!queue.empty()) {
    last = queue.front();
    queue.pop();
    for (int direction = 0; direction < 4; ++direction) {
      const int next = last + steps[direction];
      if (!open(last, direction) || next < 0 || next >= static_cast<int>(before.size())) continue;
      if (before[static_cast<std::size_t>(next)] >= 0) continue;
      before[static_cast<std::size_t>(next)] = last;
      queue.push(next);
    }
  }
  std::vector<int> way{last};
  while (way.back() != from) way.push_back(before[static_cast<std::size_t>(way.back())]);
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace

MazeWalk::MazeWalk(const world::WorldModel& model, double speed) : speed_(speed) {
  const world::MazeGrid& maze = *model.maze;
  const Vec2 start = model.starts.front().pose.position();
  const int from =
      static_cast<int>(start.y / maze.cell) * maze.columns + static_cast<int>(start.x / maze.cell);
  std::vector<Vec2> corners;
  for (const int cell : longest_way(maze, from)) {
    const int row = cell / maze.columns;
    corners.push_back({(cell % maze.columns + 0.5) * maze.cell, (row + 0.5) * maze.cell});
  }
  std::vector<Vec2> points;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const double length = norm(corners[i] - corners[i - 1]);
    for (double s = 0.0; s < length; s += kStep) {
      points.push_back(corners[i - 1] + (s / length) * (corners[i] - corners[i - 1]));
    }
  }
  // Corners are cut as by a mean over a third of a cell, twice.
  for (int round = 0; round < 2; ++round) {
    const auto reach = static_cast<long>(0.17 * maze.cell / kStep);
    const std::vector<Vec2> sharp = points;
    const auto count = static_cast<long>(sharp.size());
    for (long i = 0; i < count; ++i) {
      Vec2 sum;
      for (long k = -reach; k <= reach; ++k) {
        sum = sum + sharp[static_cast<std::size_t>(std::clamp(i + k, 0L, count - 1))];
      }
      points[static_cast<std::size_t>(i)] = (1.0 / (2.0 * static_cast<double>(reach) + 1.0)) * sum;
    }
  }
  path_ = std::move(points);
}

double MazeWalk::duration() const { return static_cast<double>(path_.size() - 1) * kStep / speed_; }

Vec2 MazeWalk::on_path(double metres) const {
  const double at = std::clamp(metres / kStep, 0.0, static_cast<double>(path_.size()) - 1.001);
  const auto i = static_cast<std::size_t>(at);
  return path_[i] + (at - static_cast<double>(i)) * (path_[i + 1] - path_[i]);
}

EyePose MazeWalk::at(double t) const {
  const double s = t * speed_;
  const Vec2 ahead = on_path(s + 0.12) - on_path(s - 0.04);
  const Vec2 at = on_path(s);
  const auto sway = [&](double size, double hertz, double phase) {
    return size * std::sin(2.0 * kPi * (hertz * t + phase));
  };
  return {{at.x + sway(0.008, 0.9, 0.1), at.y + sway(0.008, 0.7, 0.6), 0.12 + sway(0.006, 1.7, 0.0),
           wrap_angle(arc_tan2(ahead.y, ahead.x) + sway(0.05, 0.5, 0.3)), sway(0.05, 0.6, 0.2),
           sway(0.04, 0.8, 0.7)}};
}

}  // namespace eyebridge::camera::testing
