#pragma once

#include <array>
#include <vector>

/// A direction on the grid. Turning left adds one.
enum Direction { kEast = 0, kNorth = 1, kWest = 2, kSouth = 3 };

/// A cell, counted from the start cell: x to the east, y to the north.
struct Cell {
  int x = 0;
  int y = 0;
  friend bool operator==(const Cell&, const Cell&) = default;
};

Cell neighbour(Cell cell, int direction);

/// What the robot has learned of its maze. Its size need not be known before.
class MazeMap {
 public:
  enum class Edge : char { Unknown, Open, Wall };

  /// Stores what is on one side of `cell` (and so on the other side of that edge).
  void set_edge(Cell cell, int direction, bool wall);
  [[nodiscard]] Edge edge(Cell cell, int direction) const;

  void set_visited(Cell cell);
  [[nodiscard]] bool visited(Cell cell) const;
  [[nodiscard]] int visited_count() const { return visited_count_; }

  /// Directions from `from` along the shortest known way to the nearest cell for which `wanted`
  /// holds; straight on is preferred among equals. Empty when there is none or `from` is one.
  template <class Wanted>
  [[nodiscard]] std::vector<int> way(Cell from, int heading, Wanted&& wanted) const {
    std::vector<Cell> queue{from};
    std::vector<char> seen(edges_.size());
    seen[index(from)] = 1;
    for (std::size_t head = 0; head < queue.size(); ++head) {
      if (wanted(queue[head])) return way_to(from, heading, queue[head]);
      for (const Cell& next : open_neighbours(queue[head])) {
        if (seen[index(next)] != 0) continue;
        seen[index(next)] = 1;
        queue.push_back(next);
      }
    }
    return {};
  }

  /// The one to four cells in the middle of a maze of `columns` x `rows` cells, one of whose
  /// corners is the start; 0: of what was visited.
  [[nodiscard]] std::vector<Cell> centre(int columns, int rows) const;
  /// Lower left and upper right corner of what was visited.
  [[nodiscard]] std::array<Cell, 2> extent() const { return {low_, high_}; }

 private:
  static constexpr int kHalf = 128;  ///< Mazes of up to 128 cells in any direction from the start.
  static constexpr int kSide = 2 * kHalf + 1;
  [[nodiscard]] static std::size_t index(Cell cell);
  [[nodiscard]] static bool inside(Cell cell);
  [[nodiscard]] std::vector<Cell> open_neighbours(Cell cell) const;
  [[nodiscard]] std::vector<int> way_to(Cell from, int heading, Cell to) const;
  /// Distances to `to`, of the cells that are as near as `from` or nearer.
  [[nodiscard]] std::vector<int> distances(Cell to, Cell from) const;

  std::vector<std::array<Edge, 4>> edges_ = std::vector<std::array<Edge, 4>>(kSide * kSide);
  std::vector<char> visited_ = std::vector<char>(kSide * kSide);
  int visited_count_ = 0;
  Cell low_;
  Cell high_;
};
