#pragma once

#include <vector>

#include "eyebridge/base/random.hpp"
#include "eyebridge/camera/calibration.hpp"
#include "eyebridge/camera/frame.hpp"
#include "wall_picture.hpp"

namespace eyebridge::camera::testing {

/// What a cheap camera makes of a scene.
struct Effects {
  double light = 1.0;     ///< Factor on the brightness.
  double gradient = 0.0;  ///< Of the light from left to right, -1 … 1.
  double blur = 0.7;      ///< Of the lens: Gaussian, standard deviation in pixels.
  double noise = 4.0;     ///< Gaussian, a pixel, grey levels.
  int exposures = 4;      ///< Pictures that are averaged for the motion during the exposure.
};

/// Paints what a pinhole sees, then lets `lens` (distortion included) look at that.
class LensCamera {
 public:
  LensCamera(const WallPainter& painter, const Calibration& lens);

  /// A Grey8 frame, exposed while the camera goes from `from` to `to`.
  [[nodiscard]] Frame take(const EyePose& from, const EyePose& to, const Effects& effects,
                           Random& random, const std::vector<char>& hidden = {}) const;

 private:
  const WallPainter& painter_;
  Calibration lens_;
  Calibration fine_;         ///< A pinhole that sees all that lens_ does, no less finely.
  std::vector<Vec2> looks_;  ///< Where in the fine picture each pixel looks.
};

}  // namespace eyebridge::camera::testing
