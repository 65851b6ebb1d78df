#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <string>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/result.hpp"
#include "eyebridge/camera/source.hpp"

namespace eyebridge::robios {

/// The camera as CAM* calls see it: a source opened at the first init(), frames as RGB or grey.
/// Any thread; one at a time gets a frame.
class CameraPort {
 public:
  /// `url` as in --camera; "none" means that the robot has no camera. `given`, when not null, is
  /// lent and used in its place.
  CameraPort(std::string url, camera::SourceContext context, camera::Source* given = nullptr);
  ~CameraPort();

  /// Frames of `width` x `height` pixels from now on; opens the source. Throws ConfigError when the
  /// source cannot work here. Fails with NoDevice for "none".
  Result<void> init(int width, int height);
  void release();
  [[nodiscard]] bool is_open() const;

  /// The next frame, Rgb24, of the size of init(). Fails with Unsupported before init().
  Result<camera::FramePtr> next();

  /// Told of every frame that a program was given; set before the first. There is one: the session,
  /// which tells all who want to know.
  void on_frame(std::function<void(const camera::FramePtr&)> listener);

 private:
  std::string url_;
  camera::SourceContext context_;
  mutable std::mutex mutex_;
  camera::Source* const given_;
  std::unique_ptr<camera::Source> opened_;
  camera::Source* source_ = nullptr;  ///< The one that is used, if any.
  bool open_ = false;
  std::function<void(const camera::FramePtr&)> listener_;
};

}  // namespace eyebridge::robios
