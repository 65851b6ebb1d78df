#pragma once

#include <opencv2/core.hpp>

#include "fiducials/vision.hpp"

namespace eyebridge::camera {

/// `corners` of a black square on white, about a pixel off, brought onto the square: a line is laid
/// through the steepest places of each edge, and neighbouring lines are cut (the way of Wang and
/// Olson, AprilTag 2, 2016, section III). An edge that shows no step leaves its corners where they
/// are. Along an edge lie `cells`.
Corners refined(const cv::Mat& grey, const Corners& corners, int cells);

}  // namespace eyebridge::camera
