#include "render/gl_context.hpp"

#include <array>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/log.hpp"
#include "eyebridge/camera/prepare_process.hpp"
#include "eyebridge/camera/renderer.hpp"

namespace eyebridge::camera {
namespace {

constexpr std::array kMakers{
#ifdef EYEBRIDGE_HAS_OSMESA
    GlContextMaker{"osmesa", "libosmesa6", &make_osmesa_context},
#endif
    GlContextMaker{"egl", "libegl1 libegl-mesa0", &make_egl_context},
};

thread_local const GlContext* current_context = nullptr;

}  // namespace

std::span<const GlContextMaker> gl_context_makers() { return kMakers; }

void check_gl_context_maker(std::string_view name) {
  std::string known;
  for (const GlContextMaker& maker : kMakers) {
    if (name == maker.name) return;
    known += (known.empty() ? "" : ", ") + std::string(maker.name);
  }
  throw ConfigError({"--camera"},
                    "render:" + std::string(name) + " is not known, expected one of: " + known);
}

bool exchange_current(const GlContext* context) {
  const bool same = current_context == context;
  current_context = context;
  return same;
}

bool forget_current(const GlContext* context) {
  if (current_context != context) return false;
  current_context = nullptr;
  return true;
}

std::unique_ptr<GlContext> make_gl_context(std::string_view name, LogSink& log) {
  prepare_process();
  if (!name.empty()) check_gl_context_maker(name);
  std::string failures;
  for (const GlContextMaker& maker : kMakers) {
    if (!name.empty() && name != maker.name) continue;
    try {
      auto context = maker.make();
      if (!failures.empty()) {
        log.write(Severity::Warning, "rendering with " + std::string(maker.name) + ": " + failures);
      }
      return context;
    } catch (const ConfigError& error) {
      if (!name.empty()) throw;
      failures += (failures.empty() ? "" : "; ") + error.text();
    }
  }
  throw ConfigError({"--camera"}, "render: " + failures);
}

std::string renderer_here() {
  NullLog log;
  return std::string(make_gl_context("", log)->name());
}

}  // namespace eyebridge::camera
