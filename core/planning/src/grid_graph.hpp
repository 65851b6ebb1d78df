#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "eyebridge/planning/path.hpp"

namespace eyebridge::planning {

/// Length of a way through a grid, in 2^-32 of a cell's edge: integers, so that equal ways are
/// equally long whichever order they are added in, and searches need no tolerance.
using Cost = std::uint64_t;

constexpr Cost kStraightCost = Cost{1} << 32;
constexpr Cost kDiagonalCost = 6074001000;  // sqrt(2) * 2^32, to 1e-11 of it
constexpr Cost kNoWay = std::numeric_limits<Cost>::max() / 4;

/// Node of a grid: place in a raster with a rim of blocked cells, so that no neighbour is outside.
using Node = std::uint32_t;

/// One of the eight directions: 0 to 3 are right, up, left, down; 4 to 7 the diagonals after each.
struct Direction {
  int right;
  int up;
  Cost cost;
};
inline constexpr std::array<Direction, 8> kDirections{{{1, 0, kStraightCost},
                                                       {0, 1, kStraightCost},
                                                       {-1, 0, kStraightCost},
                                                       {0, -1, kStraightCost},
                                                       {1, 1, kDiagonalCost},
                                                       {-1, 1, kDiagonalCost},
                                                       {-1, -1, kDiagonalCost},
                                                       {1, -1, kDiagonalCost}}};

/// A raster as a graph of eight neighbours; diagonals only where both cells beside them are free.
class GridGraph {
 public:
  explicit GridGraph(const BlockedRaster& blocked);

  [[nodiscard]] std::size_t size() const { return blocked_.size(); }
  [[nodiscard]] Node node_of(mapping::Cell cell) const {
    return static_cast<Node>(cell.row + 1) * stride_ + static_cast<Node>(cell.column + 1);
  }
  [[nodiscard]] mapping::Cell cell_of(Node node) const {
    const Node row = node / stride_;
    return {static_cast<int>(node - row * stride_) - 1, static_cast<int>(row) - 1};
  }
  [[nodiscard]] bool is_blocked(Node node) const { return blocked_[node] != 0; }
  void set_blocked(Node node, bool blocked) { blocked_[node] = blocked ? 1 : 0; }
  [[nodiscard]] Node neighbour(Node node, std::size_t direction) const {
    return node + offsets_[direction];  // wraps around where an offset is negative
  }

  /// Which neighbours a step may go to: bit d for direction d. `node` itself is not looked at, nor
  /// is the rim a node.
  [[nodiscard]] unsigned steps_from(Node node) const {
    const auto free = [&](std::size_t d) {
      return static_cast<unsigned>(blocked_[neighbour(node, d)] == 0);
    };
    const unsigned right = free(0);
    const unsigned up = free(1);
    const unsigned left = free(2);
    const unsigned down = free(3);
    return right | up << 1 | left << 2 | down << 3 | (free(4) & right & up) << 4 |
           (free(5) & up & left) << 5 | (free(6) & left & down) << 6 |
           (free(7) & down & right) << 7;
  }

 private:
  Node stride_;
  std::array<Node, 8> offsets_;
  std::vector<std::uint8_t> blocked_;
};

/// Length of the shortest way between two cells if nothing were blocked.
inline Cost octile(mapping::Cell a, mapping::Cell b) {
  const auto distance = [](int from, int to) {
    return static_cast<Cost>(from < to ? to - from : from - to);
  };
  const Cost columns = distance(a.column, b.column);
  const Cost rows = distance(a.row, b.row);
  const Cost less = columns < rows ? columns : rows;
  const Cost more = columns < rows ? rows : columns;
  return less * kDiagonalCost + (more - less) * kStraightCost;
}

/// The centres of the cells from `from` down `costs`, which hold each node's cost to the target,
/// to a node of cost 0; only those where the way turns. Of equal ways the straighter one is taken.
std::vector<Vec2> descend(const GridGraph& graph, const std::vector<Cost>& costs, Node from,
                          const mapping::GridGeometry& geometry);

}  // namespace eyebridge::planning
