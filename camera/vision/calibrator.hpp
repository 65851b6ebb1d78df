#pragma once

#include "fiducials/vision.hpp"

namespace eyebridge::camera {

/// As make_calibrator(), with OpenCV.
std::unique_ptr<Calibrator> make_opencv_calibrator(const Board& board);

}  // namespace eyebridge::camera
