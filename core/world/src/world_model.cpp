#include "eyebridge/world/world_model.hpp"

namespace eyebridge::world {

std::vector<Wall> walls_of(const MazeGrid& maze) {
  std::vector<Wall> walls;
  const auto add = [&](double x0, double y0, double x1, double y1) {
    Wall wall;
    wall.a = {x0 * maze.cell, y0 * maze.cell};
    wall.b = {x1 * maze.cell, y1 * maze.cell};
    walls.push_back(wall);
  };
  for (int row = 0; row <= maze.rows; ++row) {
    for (int column = 0; column < maze.columns; ++column) {
      if (maze.south[static_cast<std::size_t>(row * maze.columns + column)] != 0) {
        add(column, row, column + 1, row);
      }
    }
  }
  for (int row = 0; row < maze.rows; ++row) {
    for (int column = 0; column <= maze.columns; ++column) {
      if (maze.west[static_cast<std::size_t>(row * (maze.columns + 1) + column)] != 0) {
        add(column, row, column, row + 1);
      }
    }
  }
  return walls;
}

}  // namespace eyebridge::world
