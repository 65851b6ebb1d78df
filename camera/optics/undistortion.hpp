#pragma once

#include <cstdint>
#include <vector>

#include "eyebridge/camera/calibration.hpp"
#include "eyebridge/camera/frame.hpp"

namespace eyebridge::camera {

/// Turns a lens's pictures of one size into those of a pinhole with the same focal length and
/// centre. Built once, used for many frames. Immutable: any thread.
class Undistortion {
 public:
  /// For pictures of `lens`.size.
  explicit Undistortion(const Calibration& lens);

  /// `frame`, which has that size, straightened; time and sequence are kept. What the lens did not
  /// see is black.
  [[nodiscard]] Frame apply(const Frame& frame) const;

 private:
  /// Where a pixel's value comes from: the four pixels about a point, by their distances.
  struct Look {
    std::int32_t pixel = -1;  ///< Number of the upper left one; -1: outside.
    std::uint16_t right = 0;  ///< Of the right ones, parts of kOne.
    std::uint16_t lower = 0;
  };

  Size size_;
  std::vector<Look> looks_;
};

}  // namespace eyebridge::camera
