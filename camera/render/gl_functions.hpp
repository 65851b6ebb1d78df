#pragma once

#include <GL/glcorearb.h>

#include "render/gl_context.hpp"

namespace eyebridge::camera {

// Type, our name, OpenGL's name.
// clang-format off
#define EYEBRIDGE_GL_FUNCTIONS(X) \
  X(PFNGLCLEARPROC, clear, "glClear") \
  X(PFNGLCLEARCOLORPROC, clear_color, "glClearColor") \
  X(PFNGLVIEWPORTPROC, viewport, "glViewport") \
  X(PFNGLENABLEPROC, enable, "glEnable") \
  X(PFNGLDEPTHFUNCPROC, depth_func, "glDepthFunc") \
  X(PFNGLPOLYGONOFFSETPROC, polygon_offset, "glPolygonOffset") \
  X(PFNGLPIXELSTOREIPROC, pixel_store_i, "glPixelStorei") \
  X(PFNGLREADPIXELSPROC, read_pixels, "glReadPixels") \
  X(PFNGLGETERRORPROC, get_error, "glGetError") \
  X(PFNGLGETINTEGERVPROC, get_integer_v, "glGetIntegerv") \
  X(PFNGLGENTEXTURESPROC, gen_textures, "glGenTextures") \
  X(PFNGLBINDTEXTUREPROC, bind_texture, "glBindTexture") \
  X(PFNGLTEXIMAGE2DPROC, tex_image_2d, "glTexImage2D") \
  X(PFNGLTEXPARAMETERIPROC, tex_parameter_i, "glTexParameteri") \
  X(PFNGLGENBUFFERSPROC, gen_buffers, "glGenBuffers") \
  X(PFNGLBINDBUFFERPROC, bind_buffer, "glBindBuffer") \
  X(PFNGLBUFFERDATAPROC, buffer_data, "glBufferData") \
  X(PFNGLGENVERTEXARRAYSPROC, gen_vertex_arrays, "glGenVertexArrays") \
  X(PFNGLBINDVERTEXARRAYPROC, bind_vertex_array, "glBindVertexArray") \
  X(PFNGLENABLEVERTEXATTRIBARRAYPROC, enable_vertex_attrib_array, "glEnableVertexAttribArray") \
  X(PFNGLVERTEXATTRIBPOINTERPROC, vertex_attrib_pointer, "glVertexAttribPointer") \
  X(PFNGLVERTEXATTRIBDIVISORPROC, vertex_attrib_divisor, "glVertexAttribDivisor") \
  X(PFNGLCREATESHADERPROC, create_shader, "glCreateShader") \
  X(PFNGLSHADERSOURCEPROC, shader_source, "glShaderSource") \
  X(PFNGLCOMPILESHADERPROC, compile_shader, "glCompileShader") \
  X(PFNGLGETSHADERIVPROC, get_shader_iv, "glGetShaderiv") \
  X(PFNGLGETSHADERINFOLOGPROC, get_shader_info_log, "glGetShaderInfoLog") \
  X(PFNGLDELETESHADERPROC, delete_shader, "glDeleteShader") \
  X(PFNGLCREATEPROGRAMPROC, create_program, "glCreateProgram") \
  X(PFNGLATTACHSHADERPROC, attach_shader, "glAttachShader") \
  X(PFNGLLINKPROGRAMPROC, link_program, "glLinkProgram") \
  X(PFNGLGETPROGRAMIVPROC, get_program_iv, "glGetProgramiv") \
  X(PFNGLGETPROGRAMINFOLOGPROC, get_program_info_log, "glGetProgramInfoLog") \
  X(PFNGLUSEPROGRAMPROC, use_program, "glUseProgram") \
  X(PFNGLGETUNIFORMLOCATIONPROC, get_uniform_location, "glGetUniformLocation") \
  X(PFNGLUNIFORMMATRIX4FVPROC, uniform_matrix_4fv, "glUniformMatrix4fv") \
  X(PFNGLUNIFORM1FPROC, uniform_1f, "glUniform1f") \
  X(PFNGLGENFRAMEBUFFERSPROC, gen_framebuffers, "glGenFramebuffers") \
  X(PFNGLBINDFRAMEBUFFERPROC, bind_framebuffer, "glBindFramebuffer") \
  X(PFNGLFRAMEBUFFERRENDERBUFFERPROC, framebuffer_renderbuffer, "glFramebufferRenderbuffer") \
  X(PFNGLCHECKFRAMEBUFFERSTATUSPROC, check_framebuffer_status, "glCheckFramebufferStatus") \
  X(PFNGLGENRENDERBUFFERSPROC, gen_renderbuffers, "glGenRenderbuffers") \
  X(PFNGLBINDRENDERBUFFERPROC, bind_renderbuffer, "glBindRenderbuffer") \
  X(PFNGLRENDERBUFFERSTORAGEPROC, renderbuffer_storage, "glRenderbufferStorage") \
  X(PFNGLDRAWELEMENTSPROC, draw_elements, "glDrawElements") \
  X(PFNGLDRAWELEMENTSINSTANCEDPROC, draw_elements_instanced, "glDrawElementsInstanced") \
  X(PFNGLDISABLEPROC, disable, "glDisable")
// clang-format on

/// The part of OpenGL 3.3 core that we call, fetched from one context: nothing links a GL library.
struct GlFunctions {
  /// Fetches every function from `context`, which must be current. Throws ConfigError when one is
  /// absent or the version is below 3.3.
  explicit GlFunctions(const GlContext& context);

#define EYEBRIDGE_GL_MEMBER(type, member, name) type member = nullptr;
  EYEBRIDGE_GL_FUNCTIONS(EYEBRIDGE_GL_MEMBER)
#undef EYEBRIDGE_GL_MEMBER
};

}  // namespace eyebridge::camera
