#pragma once

#include <cstdint>
#include <vector>

#include "eyebridge/base/colour.hpp"
#include "eyebridge/world/world_model.hpp"

namespace eyebridge::camera {

/// Corner of a wall, the floor or a marker, in the world.
struct WorldVertex {
  float x, y, z;
  float u, v;              ///< Texture coordinates: 1 is one texture's length.
  std::uint8_t colour[4];  ///< Tint with the shading already in it.
};

/// Corner of a body of radius 1 and height 1 that stands on the floor at the origin, facing +x.
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

/// All walls, in their order.
QuadMesh wall_mesh(const std::vector<world::Wall>& walls);
/// The floor as one quad; its texture once over all of it when `stretched`.
QuadMesh floor_mesh(const world::WorldModel& model, bool stretched);
/// The markers as fans of quads, on the floor.
QuadMesh marker_mesh(const std::vector<world::Marker>& markers);

/// A robot: a cylinder whose front is marked on its side and on its top.
BodyMesh robot_mesh();
/// A can: a cylinder with marked rims and lid.
BodyMesh can_mesh();
/// A ball of radius 1 about (0, 0, 1).
BodyMesh ball_mesh();

}  // namespace eyebridge::camera
