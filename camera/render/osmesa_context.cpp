#include <array>
#include <cstdint>

// The prototypes of GL/gl.h come along; nothing links them.
#include <GL/osmesa.h>

#include "eyebridge/base/config_error.hpp"
#include "render/gl_context.hpp"
#include "render/shared_library.hpp"

namespace eyebridge::camera {
namespace {

struct OsMesa {
  SharedLibrary library{"libOSMesa.so.8", "libosmesa6"};
  decltype(&OSMesaCreateContextAttribs) create =
      library.get<decltype(&OSMesaCreateContextAttribs)>("OSMesaCreateContextAttribs");
  decltype(&OSMesaDestroyContext) destroy =
      library.get<decltype(&OSMesaDestroyContext)>("OSMesaDestroyContext");
  decltype(&OSMesaMakeCurrent) make_current =
      library.get<decltype(&OSMesaMakeCurrent)>("OSMesaMakeCurrent");
  decltype(&OSMesaGetProcAddress) get_proc =
      library.get<decltype(&OSMesaGetProcAddress)>("OSMesaGetProcAddress");
};

const OsMesa& osmesa() {
  static const OsMesa functions;
  return functions;
}

class OsMesaContext final : public GlContext {
 public:
  OsMesaContext() : osmesa_(osmesa()) {
    constexpr std::array<int, 11> kAttributes{OSMESA_FORMAT,
                                              OSMESA_RGBA,
                                              OSMESA_DEPTH_BITS,
                                              0,
                                              OSMESA_PROFILE,
                                              OSMESA_CORE_PROFILE,
                                              OSMESA_CONTEXT_MAJOR_VERSION,
                                              3,
                                              OSMESA_CONTEXT_MINOR_VERSION,
                                              3,
                                              0};
    context_ = osmesa_.create(kAttributes.data(), nullptr);
    if (context_ == nullptr) {
      throw ConfigError({"--camera"}, "OSMesa gives no OpenGL 3.3 core context");
    }
  }
  OsMesaContext(const OsMesaContext&) = delete;
  OsMesaContext& operator=(const OsMesaContext&) = delete;
  ~OsMesaContext() override {
    forget_current(this);
    osmesa_.destroy(context_);
  }

  void make_current() override {
    if (exchange_current(this)) return;
    if (osmesa_.make_current(context_, buffer_.data(), GL_UNSIGNED_BYTE, kSide, kSide) != GL_TRUE) {
      forget_current(this);
      throw ConfigError({"--camera"}, "OSMesa cannot make its context current");
    }
  }

  [[nodiscard]] GlProc get_proc(const char* name) const override { return osmesa_.get_proc(name); }
  [[nodiscard]] std::string_view name() const override { return "osmesa"; }

 private:
  // OSMesa wants a default framebuffer in our memory; we draw into one of our own.
  static constexpr int kSide = 16;

  const OsMesa& osmesa_;
  OSMesaContext context_ = nullptr;
  std::array<std::uint8_t, kSide * kSide * 4> buffer_{};
};

}  // namespace

std::unique_ptr<GlContext> make_osmesa_context() {
  auto context = std::make_unique<OsMesaContext>();
  context->make_current();
  return context;
}

}  // namespace eyebridge::camera
