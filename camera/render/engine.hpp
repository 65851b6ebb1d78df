#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "eyebridge/camera/fiducials.hpp"
#include "eyebridge/camera/frame.hpp"
#include "eyebridge/camera/view.hpp"

namespace eyebridge {
class LogSink;
}

namespace eyebridge::camera {

/// What to draw for one picture.
struct Shot {
  world::Scene scene;
  Eye eye;
  std::uint32_t carrier = 0;                  ///< Body that is not drawn.
  std::string texture_directory;              ///< Relative texture names are searched here.
  std::optional<FiducialFamily> fiducials{};  ///< Draw those of the default layout on the walls.
  double light = 1.0;                         ///< How bright it is; 1 is usual.
  int width = 0;                              ///< Pixels.
  int height = 0;                             ///< Pixels.
};

/// Draws pictures of worlds with OpenGL: a context, its programs, and the world drawn last.
///
/// Belongs to the thread that made it. Pictures depend on the shot, the Mesa and the CPU's kind
/// only.
class RenderEngine {
 public:
  /// `maker` as for make_gl_context(). Throws ConfigError. `log` must outlive the constructor only.
  RenderEngine(std::string_view maker, LogSink& log);
  ~RenderEngine();
  RenderEngine(const RenderEngine&) = delete;
  RenderEngine& operator=(const RenderEngine&) = delete;

  /// The picture of `shot`, Rgb24. A floor texture that cannot be read gives the plain floor and
  /// one warning to `log`. Throws std::runtime_error when OpenGL reports an error, ConfigError when
  /// there can be no fiducials.
  Frame render(const Shot& shot, LogSink& log);

  /// Name of the maker that its context came from.
  [[nodiscard]] std::string_view maker() const;

  /// This thread's engine from `maker`, made at the first call; it lasts as long as the thread.
  /// Throws ConfigError.
  static RenderEngine& of_this_thread(std::string_view maker, LogSink& log);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace eyebridge::camera
