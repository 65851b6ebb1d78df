#pragma once

#include <memory>
#include <optional>
#include <string>

#include "eyebridge/bridges/monotonic_clock.hpp"
#include "eyebridge/camera/source.hpp"

namespace CLI {
class App;
}

namespace eyebridge::apps {

/// What the options say about the camera that a command looks through.
struct CameraOptions {
  std::string url;
  std::string size;  ///< "640x480"; "" for its own.
};

/// Adds --camera and --size, which fill `options`; it must outlive the parsing.
void add_camera_options(CLI::App& command, CameraOptions& options);

/// A camera without a robot, in real time.
class CameraInput {
 public:
  /// Throws ConfigError, also for a camera that needs a world.
  explicit CameraInput(const CameraOptions& options);

  [[nodiscard]] Time now() const { return clock_.now(); }
  /// The size that frames have.
  [[nodiscard]] camera::Size size() const { return size_; }

  /// The next frame; none when the user ends the command meanwhile (stop_asked()). Fails as
  /// Source::next(), with Timeout only after two seconds without one.
  Result<camera::FramePtr> next();

  /// Whether `error` is the end of a series of frames, which has one.
  [[nodiscard]] bool is_its_end(const Error& error) const;

 private:
  std::string url_;
  bridges::MonotonicClock clock_;
  std::unique_ptr<camera::Source> source_;
  camera::Size size_;
};

}  // namespace eyebridge::apps
