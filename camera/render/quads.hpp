#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/gl_functions.hpp"
#include "render/mesh.hpp"

namespace eyebridge::camera {

/// A mesh of quads in OpenGL's memory, of which some are drawn. The context that it was made in
/// must be current in every call.
class Quads {
 public:
  /// `gl` is lent for its life.
  explicit Quads(const GlFunctions& gl);

  /// Replaces the mesh; no quad of it is chosen.
  void fill(const QuadMesh& mesh);
  /// Chooses what draw() draws: the corners of triangles, in this order.
  void choose(const std::vector<std::uint32_t>& indices);
  /// Draws it with the program and the texture in use.
  void draw() const;

 private:
  const GlFunctions& gl_;
  GLuint array_ = 0;
  GLuint vertices_;
  GLuint indices_;
  GLsizei count_ = 0;
};

/// Appends the two triangles of quad number `quad`.
void add_triangles(std::uint32_t quad, std::vector<std::uint32_t>& indices);

/// The triangles of the quads `first` … `first` + `count` - 1.
std::vector<std::uint32_t> triangles_of(std::uint32_t first, std::size_t count);

}  // namespace eyebridge::camera
