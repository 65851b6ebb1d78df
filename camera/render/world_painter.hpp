#pragma once

#include <array>
#include <vector>

#include "eyebridge/world/world_model.hpp"
#include "optics/lens.hpp"
#include "render/gl_functions.hpp"
#include "render/quads.hpp"
#include "render/visible_walls.hpp"

namespace eyebridge::camera {

/// Draws walls of bricks, a floor of tiles and its markers.
///
/// The patterns are computed for each pixel, smoothed over what it covers: for llvmpipe that is
/// less than half the work of a texture with mip levels, and joints stay sharp near the eye.
class WorldPainter {
 public:
  /// `gl` is lent for its life; its context must be current here and in every call.
  explicit WorldPainter(const GlFunctions& gl);

  /// Replaces the world. Without `tiles` the floor is left to others.
  void take(const world::WorldModel& model, bool tiles);

  /// Draws what `lens` may see of walls and tiles. `light` scales all colours.
  void draw(const Lens& lens, const std::array<float, 16>& clip_from_world, float light);
  /// Draws the markers, after the floor that they lie on, like the draw() before.
  void draw_markers() const;

  /// What the walls hid in the last draw().
  [[nodiscard]] const VisibleWalls& walls() const { return visible_; }

 private:
  const GlFunctions& gl_;
  GLuint program_;
  GLint clip_from_world_;
  GLint light_;
  Quads quads_;
  Quads markers_;
  VisibleWalls visible_{{}};
  bool has_markers_ = false;
  std::vector<std::uint32_t> floor_;    ///< Its triangles.
  std::vector<std::uint32_t> indices_;  ///< Of what is drawn.
};

}  // namespace eyebridge::camera
