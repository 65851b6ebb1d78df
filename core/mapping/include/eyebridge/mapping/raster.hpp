#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "eyebridge/base/pose.hpp"

namespace eyebridge::mapping {

/// Column (along x) and row (along y) of a cell, counted from the lower left one.
struct Cell {
  int column = 0;
  int row = 0;

  friend constexpr bool operator==(Cell, Cell) = default;
};

/// Where the cells of a grid lie: squares with edges along the axes of the world.
struct GridGeometry {
  Vec2 origin;               ///< Lower left corner of cell (0, 0), metres.
  double resolution = 0.05;  ///< Edge length of a cell, metres, > 0.
  int columns = 0;
  int rows = 0;

  /// Of a floor `width` x `height` metres, both > 0, whose lower left corner is `origin`: as many
  /// whole cells as cover it.
  static GridGeometry covering(Vec2 origin, double width, double height, double resolution);

  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  }
  [[nodiscard]] bool contains(Cell cell) const {
    return cell.column >= 0 && cell.row >= 0 && cell.column < columns && cell.row < rows;
  }
  /// The cell that `point` lies in; outside of the grid, too. `point` is finite and within 2^30
  /// cells of the origin.
  [[nodiscard]] Cell cell_at(Vec2 point) const {
    return {static_cast<int>(std::floor((point.x - origin.x) / resolution)),
            static_cast<int>(std::floor((point.y - origin.y) / resolution))};
  }
  [[nodiscard]] Vec2 centre_of(Cell cell) const {
    return {origin.x + (cell.column + 0.5) * resolution, origin.y + (cell.row + 0.5) * resolution};
  }
  /// Place of a cell of the grid in row order, from the lower left one.
  [[nodiscard]] std::size_t index_of(Cell cell) const {
    return static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(cell.column);
  }

  friend bool operator==(const GridGeometry&, const GridGeometry&) = default;
};

/// A value for each cell of a grid, in row order from the lower left one.
template <class T, class Cells = std::vector<T>>
struct Raster {
  GridGeometry geometry;
  Cells cells;

  Raster() = default;
  explicit Raster(const GridGeometry& where, T value = T{})
      : geometry(where), cells(where.size(), value) {}

  /// `cell` is within the grid.
  [[nodiscard]] T& operator[](Cell cell) { return cells[geometry.index_of(cell)]; }
  [[nodiscard]] const T& operator[](Cell cell) const { return cells[geometry.index_of(cell)]; }

  friend bool operator==(const Raster&, const Raster&) = default;
};

}  // namespace eyebridge::mapping
