#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "render/gl_functions.hpp"
#include "render/textures.hpp"

namespace eyebridge::camera {

// Names of OpenGL objects live as long as their context, which frees them all at its end.

/// A program from its two shaders. Throws ConfigError with the compiler's message.
GLuint make_program(const GlFunctions& gl, const char* vertex_shader, const char* fragment_shader);

/// A repeating texture, tri-linear.
GLuint make_texture(const GlFunctions& gl);
/// Replaces the levels of `texture`.
void fill_texture(const GlFunctions& gl, GLuint texture, const std::vector<TextureLevel>& levels);

/// One attribute of a vertex array: `count` floats, or bytes mapped to 0 … 1, from `offset` on.
struct Attribute {
  GLuint index;
  GLint count;
  GLenum type;  ///< GL_FLOAT or GL_UNSIGNED_BYTE.
  std::size_t offset;
  GLuint divisor = 0;  ///< 1: advances for each instance.
};

/// Describes `buffer`, records of `stride` bytes, to the bound vertex array.
void describe(const GlFunctions& gl, GLuint buffer, std::size_t stride,
              const std::vector<Attribute>& attributes);

/// A new, empty buffer.
GLuint make_buffer(const GlFunctions& gl);

/// Replaces the contents of `buffer`.
template <class T>
void fill_buffer(const GlFunctions& gl, GLenum target, GLuint buffer, const std::vector<T>& data,
                 GLenum usage) {
  gl.bind_buffer(target, buffer);
  gl.buffer_data(target, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(), usage);
}

/// An off-screen picture with depth.
class RenderTarget {
 public:
  explicit RenderTarget(const GlFunctions& gl);

  /// Gives it `width` x `height` pixels and makes it what is drawn to. Throws std::runtime_error
  /// when OpenGL cannot.
  void resize(int width, int height);

 private:
  const GlFunctions& gl_;
  int width_ = 0;
  int height_ = 0;
  GLuint framebuffer_ = 0;
  GLuint colour_ = 0;
  GLuint depth_ = 0;
};

}  // namespace eyebridge::camera
