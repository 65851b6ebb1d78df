#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "eyebridge/world/scene.hpp"
#include "optics/lens.hpp"
#include "render/gl_functions.hpp"
#include "render/mesh.hpp"
#include "render/visible_walls.hpp"

namespace eyebridge::camera {

/// Draws robots and objects: one mesh for each round shape, one draw call for all bodies of a
/// shape. Polygons, of which hardly two are alike, have one mesh together.
class BodyPainter {
 public:
  /// `gl` is lent for its life; its context must be current here and in draw().
  explicit BodyPainter(const GlFunctions& gl);

  /// Draws those of `bodies` that `lens` may see and `walls` do not hide from it, save `carrier`.
  /// `light` scales all colours.
  void draw(std::span<const world::BodyView> bodies, std::uint32_t carrier, const Lens& lens,
            const VisibleWalls& walls, const std::array<float, 16>& clip_from_world, float light);

 private:
  struct Instance {
    float x, y, cos, sin;
    float length, width, height;  ///< Scale of the mesh.
    std::uint8_t colour[4];
    std::uint8_t mark[4];
  };
  /// Of a polygon, with what its body is like.
  struct Corner {
    BodyVertex vertex;
    Instance body;
  };
  struct Shape {
    GLuint array = 0;
    GLuint instances = 0;
    GLsizei index_count = 0;
    std::vector<Instance> visible;
  };

  [[nodiscard]] static Instance instance_of(const world::BodyView& body);
  void add_polygon(const world::BodyView& body);
  void draw_polygons();

  const GlFunctions& gl_;
  GLuint program_;
  GLint clip_from_world_;
  GLint light_;
  std::array<Shape, 3> shapes_;  ///< By world::BodyShape, but polygons.
  GLuint polygon_array_ = 0;
  GLuint polygon_corners_;
  GLuint polygon_indices_;
  std::vector<Corner> corners_;  ///< Of the polygons that are seen.
  std::vector<std::uint32_t> indices_;
};

}  // namespace eyebridge::camera
