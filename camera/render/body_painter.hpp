#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "eyebridge/world/scene.hpp"
#include "render/gl_functions.hpp"
#include "render/lens.hpp"
#include "render/visible_walls.hpp"

namespace eyebridge::camera {

/// Draws robots and objects: one mesh for each shape, one draw call for all bodies of a shape.
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
  struct Shape {
    GLuint array = 0;
    GLuint instances = 0;
    GLsizei index_count = 0;
    std::vector<Instance> visible;
  };

  [[nodiscard]] static Instance instance_of(const world::BodyView& body);

  const GlFunctions& gl_;
  GLuint program_;
  GLint clip_from_world_;
  GLint light_;
  std::array<Shape, 4> shapes_;  ///< By world::BodyShape.
};

}  // namespace eyebridge::camera
