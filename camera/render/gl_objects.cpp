#include "render/gl_objects.hpp"

#include <array>
#include <stdexcept>
#include <string>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge::camera {
namespace {

GLuint compile(const GlFunctions& gl, GLenum kind, const char* source) {
  const GLuint shader = gl.create_shader(kind);
  gl.shader_source(shader, 1, &source, nullptr);
  gl.compile_shader(shader);
  GLint ok = GL_FALSE;
  gl.get_shader_iv(shader, GL_COMPILE_STATUS, &ok);
  if (ok != GL_TRUE) {
    std::array<char, 512> text{};
    gl.get_shader_info_log(shader, text.size(), nullptr, text.data());
    throw ConfigError({"--camera"}, std::string("OpenGL refuses a shader: ") + text.data());
  }
  return shader;
}

}  // namespace

GLuint make_program(const GlFunctions& gl, const char* vertex_shader, const char* fragment_shader) {
  const GLuint program = gl.create_program();
  for (const GLuint shader : {compile(gl, GL_VERTEX_SHADER, vertex_shader),
                              compile(gl, GL_FRAGMENT_SHADER, fragment_shader)}) {
    gl.attach_shader(program, shader);
    gl.delete_shader(shader);
  }
  gl.link_program(program);
  GLint ok = GL_FALSE;
  gl.get_program_iv(program, GL_LINK_STATUS, &ok);
  if (ok != GL_TRUE) {
    std::array<char, 512> text{};
    gl.get_program_info_log(program, text.size(), nullptr, text.data());
    throw ConfigError({"--camera"}, std::string("OpenGL refuses a program: ") + text.data());
  }
  return program;
}

GLuint make_texture(const GlFunctions& gl) {
  GLuint texture = 0;
  gl.gen_textures(1, &texture);
  gl.bind_texture(GL_TEXTURE_2D, texture);
  gl.tex_parameter_i(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
  gl.tex_parameter_i(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
  gl.tex_parameter_i(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  gl.tex_parameter_i(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  return texture;
}

void fill_texture(const GlFunctions& gl, GLuint texture, const std::vector<TextureLevel>& levels) {
  gl.bind_texture(GL_TEXTURE_2D, texture);
  gl.tex_parameter_i(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(levels.size()) - 1);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    gl.tex_image_2d(GL_TEXTURE_2D, static_cast<GLint>(i), GL_RGBA8, levels[i].width,
                    levels[i].height, 0, GL_RGBA, GL_UNSIGNED_BYTE, levels[i].rgba.data());
  }
}

void describe(const GlFunctions& gl, GLuint buffer, std::size_t stride,
              const std::vector<Attribute>& attributes) {
  gl.bind_buffer(GL_ARRAY_BUFFER, buffer);
  for (const Attribute& attribute : attributes) {
    gl.enable_vertex_attrib_array(attribute.index);
    gl.vertex_attrib_pointer(attribute.index, attribute.count, attribute.type,
                             attribute.type == GL_UNSIGNED_BYTE ? GL_TRUE : GL_FALSE,
                             static_cast<GLsizei>(stride),
                             reinterpret_cast<const void*>(attribute.offset));
    gl.vertex_attrib_divisor(attribute.index, attribute.divisor);
  }
}

GLuint make_buffer(const GlFunctions& gl) {
  GLuint buffer = 0;
  gl.gen_buffers(1, &buffer);
  return buffer;
}

RenderTarget::RenderTarget(const GlFunctions& gl) : gl_(gl) {
  gl_.gen_framebuffers(1, &framebuffer_);
  gl_.gen_renderbuffers(1, &colour_);
  gl_.gen_renderbuffers(1, &depth_);
}

void RenderTarget::resize(int width, int height) {
  gl_.bind_framebuffer(GL_FRAMEBUFFER, framebuffer_);
  if (width == width_ && height == height_) return;
  gl_.bind_renderbuffer(GL_RENDERBUFFER, colour_);
  gl_.renderbuffer_storage(GL_RENDERBUFFER, GL_RGBA8, width, height);
  gl_.bind_renderbuffer(GL_RENDERBUFFER, depth_);
  gl_.renderbuffer_storage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
  gl_.framebuffer_renderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_);
  gl_.framebuffer_renderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
  if (gl_.check_framebuffer_status(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    width_ = height_ = 0;
    throw std::runtime_error("OpenGL cannot draw a picture of " + std::to_string(width) + " x " +
                             std::to_string(height) + " pixels");
  }
  gl_.viewport(0, 0, width, height);
  width_ = width;
  height_ = height;
}

}  // namespace eyebridge::camera
