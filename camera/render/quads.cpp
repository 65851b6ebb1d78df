#include "render/quads.hpp"

#include <cstddef>

#include "render/gl_objects.hpp"

namespace eyebridge::camera {

Quads::Quads(const GlFunctions& gl)
    : gl_(gl), vertices_(make_buffer(gl)), indices_(make_buffer(gl)) {
  gl_.gen_vertex_arrays(1, &array_);
  gl_.bind_vertex_array(array_);
  gl_.bind_buffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
  describe(gl_, vertices_, sizeof(WorldVertex),
           {{0, 3, GL_FLOAT, offsetof(WorldVertex, x)},
            {1, 2, GL_FLOAT, offsetof(WorldVertex, u)},
            {2, 4, GL_UNSIGNED_BYTE, offsetof(WorldVertex, colour)}});
}

void Quads::fill(const QuadMesh& mesh) {
  gl_.bind_vertex_array(array_);
  fill_buffer(gl_, GL_ARRAY_BUFFER, vertices_, mesh.vertices, GL_STATIC_DRAW);
  count_ = 0;
}

void Quads::choose(const std::vector<std::uint32_t>& indices) {
  gl_.bind_vertex_array(array_);
  fill_buffer(gl_, GL_ELEMENT_ARRAY_BUFFER, indices_, indices, GL_STREAM_DRAW);
  count_ = static_cast<GLsizei>(indices.size());
}

void Quads::draw() const {
  if (count_ == 0) return;
  gl_.bind_vertex_array(array_);
  gl_.draw_elements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
}

void add_triangles(std::uint32_t quad, std::vector<std::uint32_t>& indices) {
  for (const std::uint32_t i : {0U, 1U, 2U, 0U, 2U, 3U}) indices.push_back(4 * quad + i);
}

std::vector<std::uint32_t> triangles_of(std::uint32_t first, std::size_t count) {
  std::vector<std::uint32_t> indices;
  for (std::size_t i = 0; i < count; ++i) {
    add_triangles(first + static_cast<std::uint32_t>(i), indices);
  }
  return indices;
}

}  // namespace eyebridge::camera
