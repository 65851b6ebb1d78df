#pragma once

#include <vector>

#include "eyebridge/camera/calibration.hpp"
#include "optics/eye_pose.hpp"

namespace eyebridge::camera::testing {

/// A webcam of 320 x 240 pixels whose lens bends straight lines.
Calibration bent_webcam();

/// Twelve eyes for look_at_page(): somebody holds a board into the picture, `distance` metres away,
/// here and there, slanted to all sides.
std::vector<EyePose> board_views(double distance);

}  // namespace eyebridge::camera::testing
