#pragma once

#include <opencv2/aruco/dictionary.hpp>

#include "eyebridge/camera/fiducials.hpp"

namespace eyebridge::camera {

/// The dictionary of our fiducials and of ChArUco boards.
const cv::Ptr<cv::aruco::Dictionary>& dictionary();

/// As fiducial_bits().
FiducialBits bits_of(int id);

}  // namespace eyebridge::camera
