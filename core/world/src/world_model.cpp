#include "eyebridge/world/world_model.hpp"

#include <algorithm>

#include "eyebridge/world/scene.hpp"

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
  if (kind == ObjectKind::Box) return norm(size) / 2;
  if (kind != ObjectKind::Polygon) return radius;
  double farthest = 0.0;
  for (const Vec2 corner : corners) farthest = std::max(farthest, norm(corner));
  return farthest;
}

std::optional<CornerFault> fault_of_corners(const std::vector<Vec2>& corners) {
  // Metres: what is flatter has no inside that anything could be told of.
  constexpr double kFlat = 1e-5;
  const std::size_t count = corners.size();
  if (count < 3) return CornerFault{count, "three corners or more"};
  if (count > kMostCorners) {
    return CornerFault{kMostCorners, "no more than " + std::to_string(kMostCorners) + " corners"};
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 from = corners[i];
    const Vec2 along = corners[(i + 1) % count] - from;
    const double length = norm(along);
    if (!(length > kFlat)) return CornerFault{(i + 1) % count, "another place than the one before"};
    const auto to_left = [&](Vec2 p) { return cross(along, p - from) / length; };
    if (!(to_left({}) > kFlat)) {
      return CornerFault{i, "corners that go round (0, 0), counter-clockwise as they are kept"};
    }
    for (std::size_t k = 2; k < count; ++k) {
      const std::size_t other = (i + k) % count;
      if (!(to_left(corners[other]) > kFlat)) {
        return CornerFault{other, "an outline without a dent, no three corners in a line"};
      }
    }
  }
  return std::nullopt;
}

std::vector<Vec2> corners_of(const ObjectSpec& object) {
  if (object.kind == ObjectKind::Polygon) return object.corners;
  if (object.kind != ObjectKind::Box) return {};
  const Vec2 half = 0.5 * object.size;
  return {{half.x, half.y}, {-half.x, half.y}, {-half.x, -half.y}, {half.x, -half.y}};
}

double rim_distance(const ObjectSpec& object, Vec2 p) {
  return rim_distance(view_of(object, 0), p);
}

}  // namespace eyebridge::world
