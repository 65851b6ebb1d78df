#pragma once

#include <memory>
#include <vector>

#include "eyebridge/base/random.hpp"
#include "eyebridge/world/world_model.hpp"

namespace eyebridge::world {

/// A room of `width` x `height` metres, closed by four walls, with its lower left at the origin.
inline WorldModel room(double width, double height) {
  WorldModel model;
  model.width = width;
  model.height = height;
  const Vec2 corners[] = {{0, 0}, {width, 0}, {width, height}, {0, height}};
  for (std::size_t i = 0; i < 4; ++i) {
    Wall wall;
    wall.a = corners[i];
    wall.b = corners[(i + 1) % 4];
    model.walls.push_back(wall);
  }
  return model;
}

/// `model`, shared as a World wants it.
inline std::shared_ptr<const WorldModel> shared(WorldModel model) {
  return std::make_shared<const WorldModel>(std::move(model));
}

/// `count` walls of 0.05 to 0.6 m at any angle in a closed room of `size` metres; every third is
/// `thickness` metres thick.
inline WorldModel random_walls(std::uint64_t seed, int count, double size, double thickness) {
  Random random(seed);
  WorldModel model = room(size, size);
  for (int i = 0; i < count; ++i) {
    Wall wall;
    wall.a = {random.uniform() * size, random.uniform() * size};
    const Heading h = Heading::from_angle(random.uniform() * 6.28);
    wall.b = wall.a + (0.05 + 0.55 * random.uniform()) * h.forward();
    wall.thickness = i % 3 == 0 ? thickness : 0.0;
    model.walls.push_back(wall);
  }
  return model;
}

/// A closed maze of `side` x `side` cells in which each inner edge stands with probability
/// `density`.
inline WorldModel random_maze(std::uint64_t seed, int side, double density, double cell = 0.36) {
  Random random(seed);
  MazeGrid maze;
  maze.columns = side;
  maze.rows = side;
  maze.cell = cell;
  for (int row = 0; row <= side; ++row) {
    for (int column = 0; column < side; ++column) {
      maze.south.push_back(row == 0 || row == side || random.chance(density));
    }
  }
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column <= side; ++column) {
      maze.west.push_back(column == 0 || column == side || random.chance(density));
    }
  }
  WorldModel model;
  model.width = model.height = side * cell;
  model.walls = walls_of(maze);
  model.maze = maze;
  return model;
}

/// `count` unit vectors, evenly spread.
inline std::vector<Vec2> directions_around(int count) {
  std::vector<Vec2> directions;
  for (int i = 0; i < count; ++i) {
    directions.push_back(Heading::from_angle(2 * 3.141592653589793 * i / count).forward());
  }
  return directions;
}

}  // namespace eyebridge::world
