#pragma once

#include "fiducials/vision.hpp"

namespace eyebridge::camera {

/// The one implementation, with OpenCV kept to the caller's thread.
const Vision& opencv_vision();

}  // namespace eyebridge::camera
