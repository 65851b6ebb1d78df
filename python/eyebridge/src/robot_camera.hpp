#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "eyebridge/base/jumping_clock.hpp"
#include "eyebridge/camera/source.hpp"
#include "shared_simulation.hpp"

namespace eyebridge::python {

/// The camera of a simulated robot: pictures of the world as it is when they are asked for. Any
/// thread; calls wait for each other.
class RobotCamera {
 public:
  /// `url` is "render" with its options. Throws ConfigError for one that cannot be, and
  /// std::invalid_argument for a robot without a camera or a size that cannot be.
  RobotCamera(std::shared_ptr<SharedSimulation> simulation, robot::RobotIndex robot, int width,
              int height, std::string url);
  ~RobotCamera();

  /// The next frame, Rgb24. Its noise follows from the seed and how many frames there were since
  /// the start or the last reset. Throws std::runtime_error when it cannot be drawn.
  camera::FramePtr frame();

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

 private:
  class View;
  void open();

  const std::shared_ptr<SharedSimulation> simulation_;
  const std::unique_ptr<View> view_;
  const int width_;
  const int height_;
  const std::string url_;
  std::mutex mutex_;
  std::uint64_t generation_ = 0;
  std::unique_ptr<JumpingClock>
      clock_;  ///< The camera's own: whoever waits for a frame finds it due.
  std::unique_ptr<camera::Source> source_;
};

}  // namespace eyebridge::python
