#pragma once

#include <cmath>
#include <memory>

#include "eyebridge/base/random.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/world/world_model.hpp"

namespace eyebridge::bench {

/// A perfect maze (one way between any two cells) of about `walls` walls, drawn with a fixed seed:
/// side x side cells have about side^2 + 2 side walls.
inline world::WorldModel perfect_maze(int walls, double cell = 0.36) {
  const int side = static_cast<int>(std::sqrt(walls + 1.0) - 1.0 + 0.5);
  world::MazeGrid maze;
  maze.columns = maze.rows = side;
  maze.cell = cell;
  maze.south.assign(static_cast<std::size_t>(side * (side + 1)), 1);
  maze.west.assign(maze.south.size(), 1);
  Random random(42);
  std::vector<char> seen(static_cast<std::size_t>(side * side), 0);
  std::vector<int> path{0};
  seen[0] = 1;
  while (!path.empty()) {
    const int at = path.back();
    const int column = at % side;
    const int row = at / side;
    int ways[4];
    int count = 0;
    if (column + 1 < side && seen[static_cast<std::size_t>(at + 1)] == 0) ways[count++] = at + 1;
    if (column > 0 && seen[static_cast<std::size_t>(at - 1)] == 0) ways[count++] = at - 1;
    if (row + 1 < side && seen[static_cast<std::size_t>(at + side)] == 0) ways[count++] = at + side;
    if (row > 0 && seen[static_cast<std::size_t>(at - side)] == 0) ways[count++] = at - side;
    if (count == 0) {
      path.pop_back();
      continue;
    }
    const int to = ways[random.bits() % static_cast<unsigned>(count)];
    const int low = std::min(at, to);
    if (std::abs(to - at) == 1) {
      maze.west[static_cast<std::size_t>(row * (side + 1) + low % side + 1)] = 0;
    } else {
      maze.south[static_cast<std::size_t>((low / side + 1) * side + column)] = 0;
    }
    seen[static_cast<std::size_t>(to)] = 1;
    path.push_back(to);
  }
  world::WorldModel model;
  model.width = model.height = side * cell;
  model.walls = world::walls_of(maze);
  model.maze = maze;
  return model;
}

/// `walls` walls in `size` x `size` metres: boxes at random places and angles.
inline world::WorldModel open_scene(int walls, double size) {
  Random random(43);
  world::WorldModel model;
  model.width = model.height = size;
  const double edge = 0.4 * size / std::sqrt(walls / 4.0);
  for (int i = 0; i < walls / 4; ++i) {
    Vec2 corner{random.uniform() * size, random.uniform() * size};
    Heading heading = Heading::from_angle(2 * kPi * random.uniform());
    for (int k = 0; k < 4; ++k) {
      world::Wall wall;
      wall.a = corner;
      wall.b = corner + edge * heading.forward();
      corner = wall.b;
      heading = {-heading.sin, heading.cos};
      model.walls.push_back(wall);
    }
  }
  return model;
}

}  // namespace eyebridge::bench
