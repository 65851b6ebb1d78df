#pragma once

#include <algorithm>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "eyebridge/world/world_model.hpp"

namespace eyebridge {

/// Which cells of a maze can be reached from its first start, and how far they are, by a flood fill
/// of the file: nothing of the explorer's own.
class MazeReach {
 public:
  using Cell = world::MazeCell;

  explicit MazeReach(const world::WorldModel& model)
      : maze_(*model.maze), distance_(index({0, maze_.rows}), -1) {
    const Pose start = model.starts.at(0).pose;
    std::deque<Cell> queue{
        {static_cast<int>(start.x / maze_.cell), static_cast<int>(start.y / maze_.cell)}};
    low_ = high_ = queue[0];
    distance_[index(queue[0])] = 0;
    for (; !queue.empty(); queue.pop_front()) visit(queue);
  }

  /// Nothing between the start and the world outside the maze.
  [[nodiscard]] bool is_open() const { return open_; }

  /// Length in cells of the shortest way to the middle of what can be reached.
  [[nodiscard]] std::optional<int> way_to_centre() const { return way_to_middle(low_, high_); }
  /// The same to the middle of the maze.
  [[nodiscard]] std::optional<int> way_to_own_centre() const {
    return way_to_middle({0, 0}, {maze_.columns - 1, maze_.rows - 1});
  }

 private:
  [[nodiscard]] std::optional<int> way_to_middle(Cell low, Cell high) const {
    std::optional<int> best;
    for (int y = (low.row + high.row) / 2; y <= (low.row + high.row + 1) / 2; ++y) {
      for (int x = (low.column + high.column) / 2; x <= (low.column + high.column + 1) / 2; ++x) {
        const int distance = distance_[index({x, y})];
        if (distance >= 0 && (!best || distance < *best)) best = distance;
      }
    }
    return best;
  }

  [[nodiscard]] std::size_t index(Cell c) const {
    return static_cast<std::size_t>(c.row * maze_.columns + c.column);
  }

  [[nodiscard]] bool can_pass(Cell c, int dx, int dy) const {
    const int x = c.column + (dx > 0 ? 1 : 0);
    const int y = c.row + (dy > 0 ? 1 : 0);
    return dx != 0 ? maze_.west[static_cast<std::size_t>(y * (maze_.columns + 1) + x)] == 0
                   : maze_.south[static_cast<std::size_t>(y * maze_.columns + x)] == 0;
  }

  void visit(std::deque<Cell>& queue) {
    const Cell here = queue.front();
    low_ = {std::min(low_.column, here.column), std::min(low_.row, here.row)};
    high_ = {std::max(high_.column, here.column), std::max(high_.row, here.row)};
    for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) {
      if (!can_pass(here, dx, dy)) continue;
      const Cell next{here.column + dx, here.row + dy};
      if (next.column < 0 || next.row < 0 || next.column >= maze_.columns ||
          next.row >= maze_.rows) {
        open_ = true;
      } else if (distance_[index(next)] < 0) {
        distance_[index(next)] = distance_[index(here)] + 1;
        queue.push_back(next);
      }
    }
  }

  const world::MazeGrid& maze_;
  std::vector<int> distance_;
  Cell low_;
  Cell high_;
  bool open_ = false;
};

}  // namespace eyebridge
