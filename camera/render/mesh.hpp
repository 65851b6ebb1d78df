#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "eyebridge/base/colour.hpp"
#include "eyebridge/world/world_model.hpp"

namespace eyebridge::camera {

/// What a quad is covered with.
enum class Pattern : std::uint8_t { Plain, Bricks, Tiles };

/// Edge lengths of the patterns' pieces, metres. Bricks are laid in running bond.
inline constexpr double kBrickLength = 0.1;
inline constexpr double kCourseHeight = 0.05;
inline constexpr double kTileSize = 0.15;

/// Corner of a wall, the floor, a marker or a fiducial, in the world.
struct WorldVertex {
  float x, y, z;
  float u, v;              ///< In the pattern or the picture: 1 is a brick, a tile, a picture.
  std::uint8_t colour[3];  ///< Tint with the shading already in it.
  Pattern pattern;
};

/// Corner of a body of height 1 that stands on the floor at the origin, facing +x: of radius 1, or
/// a polygon of its own size.
struct BodyVertex {
  float x, y, z;
  float nx, ny, nz;  ///< Normal.
  float mark;        ///< 0: the body's colour, 1: that of its marks.
};

/// The four corners of quad q are vertices 4 q … 4 q + 3, in order round it.
struct QuadMesh {
  std::vector<WorldVertex> vertices;
};

/// A mesh of triangles for bodies.
struct BodyMesh {
  std::vector<BodyVertex> vertices;
  std::vector<std::uint32_t> indices;
};

/// Quads of a wall: one for a bare line; for a thick wall two sides, two ends and the top, in this
/// order, starting with the side to the left of a–b.
inline constexpr int kQuadsOfLine = 1;
inline constexpr int kQuadsOfBox = 5;

/// Number of quads that `wall` has.
constexpr int quads_of(const world::Wall& wall) {
  return wall.thickness > 0.0 ? kQuadsOfBox : kQuadsOfLine;
}

/// The corners of a thick wall seen from above, clockwise: left of a, left of b, right of b, right
/// of a.
std::array<Vec2, 4> outline_of(const world::Wall& wall);

/// All walls, in their order.
QuadMesh wall_mesh(const std::vector<world::Wall>& walls);
/// The floor as one quad: of tiles, or plain with one picture over all of it.
QuadMesh floor_mesh(const world::WorldModel& model, Pattern pattern);
/// The markers as fans of quads, on the floor.
QuadMesh marker_mesh(const std::vector<world::Marker>& markers);

/// Brightness of an upright face, 0.7 … 1: by its direction only, so that both sides of a bare wall
/// look alike and walls that meet at a corner do not. `normal` is a unit vector.
double light_on(Vec2 normal);

/// A corner of a quad: its place and what it shows.
struct Corner {
  Vec2 at;   ///< World, metres.
  double z;  ///< Metres.
  double u;
  double v;
};

/// Appends a quad; `light` scales its colour.
void add_quad(QuadMesh& mesh, const std::array<Corner, 4>& corners, Rgb colour, Pattern pattern,
              double light);

/// A robot: a cylinder whose front is marked on its side and on its top.
BodyMesh robot_mesh();
/// A can: a cylinder with marked rims and lid.
BodyMesh can_mesh();
/// A ball of radius 1 about (0, 0, 1).
BodyMesh ball_mesh();
/// What stands on a convex polygon, corners counter-clockwise, with a marked lid.
BodyMesh polygon_mesh(const std::vector<Vec2>& corners);

}  // namespace eyebridge::camera
