#include "eyebridge/world/world_model.hpp"

#include "boxes.hpp"

namespace eyebridge::world {

std::vector<Wall> walls_around(double width, double height) {
  const Vec2 corners[] = {{0, 0}, {width, 0}, {width, height}, {0, height}};
  std::vector<Wall> walls(4);
  for (std::size_t i = 0; i < 4; ++i) {
    walls[i].a = corners[i];
    walls[i].b = corners[(i + 1) % 4];
  }
  return walls;
}

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

double ObjectSpec::outer_radius() const {
  return kind == ObjectKind::Box ? norm(size) / 2 : radius;
}

double rim_distance(const ObjectSpec& object, Vec2 p) {
  if (object.kind != ObjectKind::Box) return norm(p - object.pose.position()) - object.radius;
  const Heading heading = Heading::from_angle(object.pose.theta);
  return distance_to({object.pose.position(), heading.forward(), 0.5 * object.size}, p);
}

}  // namespace eyebridge::world
