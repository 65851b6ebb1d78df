#pragma once

#include <array>
#include <vector>

#include "render/gl_functions.hpp"
#include "render/quads.hpp"
#include "render/textures.hpp"

namespace eyebridge::camera {

/// Draws quads that show parts of one picture.
class PicturePainter {
 public:
  /// How pixels of the picture look when they are larger than those of the frame.
  enum class Edges {
    Smooth,  ///< One runs into the next.
    Sharp,   ///< As squares.
  };

  /// `gl` is lent for its life; its context must be current here and in every call.
  PicturePainter(const GlFunctions& gl, Edges edges);

  /// Replaces the picture and the quads.
  void take(const std::vector<TextureLevel>& picture, const QuadMesh& mesh);

  /// Draws the triangles `indices`; `light` scales all colours. With `on_top` they win over what
  /// was drawn in their plane before.
  void draw(const std::vector<std::uint32_t>& indices, const std::array<float, 16>& clip_from_world,
            float light, bool on_top);

 private:
  const GlFunctions& gl_;
  GLuint program_;
  GLint clip_from_world_;
  GLint light_;
  GLuint texture_;
  Quads quads_;
};

}  // namespace eyebridge::camera
