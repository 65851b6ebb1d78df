#pragma once

#include "fiducials/vision.hpp"

namespace eyebridge::camera {

/// As Vision::find_fiducials().
std::vector<SeenFiducial> find_fiducials(const Frame& frame, FiducialFamily family);

/// As Vision::square_poses().
std::vector<SquarePose> square_poses(const Corners& corners, double size);

}  // namespace eyebridge::camera
