#pragma once

#include <opencv2/core.hpp>

#include "eyebridge/camera/frame.hpp"

namespace eyebridge::camera {

/// `frame` as one byte a pixel. A Grey8 frame is not copied: it must outlive the result, which is
/// not to be written to.
cv::Mat grey_of(const Frame& frame);

}  // namespace eyebridge::camera
