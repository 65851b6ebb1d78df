#pragma once

#include <cstdint>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/result.hpp"

namespace eyebridge::camera {

/// A moment at which a camera takes a frame.
struct FrameSlot {
  Time time{0};
  std::uint64_t sequence = 0;
};

/// The rhythm of a simulated camera: 30 frames a second of the robot's clock, from its zero on.
class FrameSchedule {
 public:
  static constexpr std::int64_t kFramesPerSecond = 30;
  static constexpr int kLargestSide = 4096;  ///< Of a frame, pixels.

  /// Waits on `clock` for the first frame time from now on that has not been given out, and gives
  /// it out. Fails with Timeout when that lies past `deadline`, after waiting until `deadline`.
  Result<FrameSlot> next(Clock& clock, Time deadline);

  /// OutOfRange unless both sides are 1 … kLargestSide pixels.
  static Result<void> check_size(int width, int height);

 private:
  std::int64_t next_ = 0;    ///< Number of the first frame time that may be given out.
  std::int64_t first_ = -1;  ///< Number of the one given out first; -1: none yet.
};

}  // namespace eyebridge::camera
