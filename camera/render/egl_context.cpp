#include <array>

#define EGL_NO_X11  // the platform headers would define None, Bool and Status
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "eyebridge/base/config_error.hpp"
#include "render/gl_context.hpp"
#include "render/shared_library.hpp"

namespace eyebridge::camera {
namespace {

[[noreturn]] void egl_failed(const std::string& what) {
  throw ConfigError({"--camera"}, "EGL " + what + "; is libegl-mesa0 installed?");
}

struct Egl {
  SharedLibrary library{"libEGL.so.1", "libegl1 libegl-mesa0"};
  decltype(&eglGetProcAddress) get_proc =
      library.get<decltype(&eglGetProcAddress)>("eglGetProcAddress");
  decltype(&eglInitialize) initialize = library.get<decltype(&eglInitialize)>("eglInitialize");
  decltype(&eglBindAPI) bind_api = library.get<decltype(&eglBindAPI)>("eglBindAPI");
  decltype(&eglCreateContext) create = library.get<decltype(&eglCreateContext)>("eglCreateContext");
  decltype(&eglDestroyContext) destroy =
      library.get<decltype(&eglDestroyContext)>("eglDestroyContext");
  decltype(&eglMakeCurrent) make_current = library.get<decltype(&eglMakeCurrent)>("eglMakeCurrent");
  EGLDisplay display = EGL_NO_DISPLAY;

  Egl() {
    const auto get_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(get_proc("eglGetPlatformDisplayEXT"));
    if (get_display == nullptr) egl_failed("has no eglGetPlatformDisplayEXT");
    display = get_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    if (display == EGL_NO_DISPLAY) egl_failed("offers no surfaceless display");
    if (initialize(display, nullptr, nullptr) != EGL_TRUE) egl_failed("cannot be initialised");
  }
};

const Egl& egl() {
  static const Egl functions;  // The display lasts as long as the process.
  return functions;
}

class EglContext final : public GlContext {
 public:
  EglContext() : egl_(egl()) {
    if (egl_.bind_api(EGL_OPENGL_API) != EGL_TRUE) egl_failed("has no desktop OpenGL");
    constexpr std::array<EGLint, 7> kAttributes{EGL_CONTEXT_MAJOR_VERSION,
                                                3,
                                                EGL_CONTEXT_MINOR_VERSION,
                                                3,
                                                EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                                EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                                EGL_NONE};
    context_ = egl_.create(egl_.display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kAttributes.data());
    if (context_ == EGL_NO_CONTEXT) egl_failed("gives no OpenGL 3.3 core context");
  }
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;
  ~EglContext() override {
    // A current context would live on until its thread ends.
    if (forget_current(this)) {
      egl_.make_current(egl_.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    egl_.destroy(egl_.display, context_);
  }

  void make_current() override {
    if (exchange_current(this)) return;
    if (egl_.make_current(egl_.display, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE) {
      forget_current(this);
      egl_failed("cannot make its context current");
    }
  }

  [[nodiscard]] GlProc get_proc(const char* name) const override { return egl_.get_proc(name); }
  [[nodiscard]] std::string_view name() const override { return "egl"; }

 private:
  const Egl& egl_;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<GlContext> make_egl_context() {
  auto context = std::make_unique<EglContext>();
  context->make_current();
  return context;
}

}  // namespace eyebridge::camera
