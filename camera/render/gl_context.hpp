#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace eyebridge {
class LogSink;
}

namespace eyebridge::camera {

using GlProc = void (*)();

/// An OpenGL 3.3 core context without a window. Used by the thread that made it, and by no other.
///
/// Pictures go to a framebuffer object of the user's, so that every maker gives the same pixels.
class GlContext {
 public:
  virtual ~GlContext() = default;

  /// Makes it the thread's context; cheap when it is that already. Throws ConfigError on failure.
  virtual void make_current() = 0;
  /// The OpenGL function `name`, or null. The context must be current.
  [[nodiscard]] virtual GlProc get_proc(const char* name) const = 0;
  /// Row of the table that it came from.
  [[nodiscard]] virtual std::string_view name() const = 0;
};

/// One way to come by a context.
struct GlContextMaker {
  std::string_view name;                 ///< "osmesa", "egl"
  std::string_view package;              ///< Debian package with its library.
  std::unique_ptr<GlContext> (*make)();  ///< Throws ConfigError.
};

/// All makers of this build, in order of preference; "osmesa" only where Mesa still has it.
std::span<const GlContextMaker> gl_context_makers();

/// Throws ConfigError, naming the known makers, unless `name` is one.
void check_gl_context_maker(std::string_view name);

/// A context from the maker `name`, current on return; "" takes the first maker that works and
/// tells `log` when that is not the first row. Throws ConfigError naming what is known or missing.
std::unique_ptr<GlContext> make_gl_context(std::string_view name, LogSink& log);

/// The makers' functions.
std::unique_ptr<GlContext> make_osmesa_context();
std::unique_ptr<GlContext> make_egl_context();

/// Notes that `context` is current on this thread; true when it was already. Both makers share
/// Mesa's dispatch table of a thread, so only one of their contexts can be current at a time.
bool exchange_current(const GlContext* context);
/// Forgets `context` when it is current on this thread; true when it was.
bool forget_current(const GlContext* context);

}  // namespace eyebridge::camera
