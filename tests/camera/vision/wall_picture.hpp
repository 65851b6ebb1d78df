#pragma once

#include <span>
#include <vector>

#include "eyebridge/camera/calibration.hpp"
#include "eyebridge/camera/fiducials.hpp"
#include "eyebridge/camera/frame.hpp"
#include "eyebridge/world/world_model.hpp"
#include "optics/eye_pose.hpp"

namespace eyebridge::camera::testing {

/// Draws walls and fiducials as a pinhole camera sees them, in grey, pixel by pixel from the
/// formulas: a second opinion on the renderer, and on the pose finder's projection.
class WallPainter {
 public:
  static constexpr double kFloor = 90.0;
  static constexpr double kWall = 170.0;
  static constexpr double kPaper = 235.0;
  static constexpr double kInk = 20.0;

  /// Walls of `model` with `fiducials` on them; fiducials are looked up once.
  WallPainter(const world::WorldModel& model, const std::vector<Fiducial>& fiducials);

  /// Brightness 0 … 255 of each pixel of `lens` (its distortion is not looked at) from `eye`, row
  /// by row; fiducials whose flag in `hidden` is set are not drawn (empty: all are).
  [[nodiscard]] std::vector<float> paint(const EyePose& eye, const Calibration& lens,
                                         const std::vector<char>& hidden = {}) const;

 private:
  /// A rectangle in space: a point of it is origin + u across + v up.
  struct Panel {
    Vec3 origin;
    Vec3 across;
    Vec3 up;
    int fiducial = -1;  ///< Index, or a bare wall.
  };

  std::vector<Panel> panels_;
  std::vector<FiducialBits> bits_;
  int cells_ = 0;  ///< Of all: they are of one family.
};

}  // namespace eyebridge::camera::testing
