#include "render/gl_functions.hpp"

#include <string>

#include "eyebridge/base/config_error.hpp"

namespace eyebridge::camera {

GlFunctions::GlFunctions(const GlContext& context) {
  const auto fetch = [&](const char* name) {
    const GlProc proc = context.get_proc(name);
    if (proc == nullptr) {
      throw ConfigError({"--camera"}, std::string(context.name()) + " has no function " + name);
    }
    return proc;
  };
#define EYEBRIDGE_GL_FETCH(type, member, name) member = reinterpret_cast<type>(fetch(name));
  EYEBRIDGE_GL_FUNCTIONS(EYEBRIDGE_GL_FETCH)
#undef EYEBRIDGE_GL_FETCH

  GLint major = 0;
  GLint minor = 0;
  get_integer_v(GL_MAJOR_VERSION, &major);
  get_integer_v(GL_MINOR_VERSION, &minor);
  if (major * 10 + minor < 33) {
    throw ConfigError({"--camera"}, std::string(context.name()) + " offers OpenGL " +
                                        std::to_string(major) + "." + std::to_string(minor) +
                                        ", rendering needs 3.3");
  }
}

}  // namespace eyebridge::camera
