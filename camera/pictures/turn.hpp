#pragma once

#include "eyebridge/camera/frame.hpp"

namespace eyebridge::camera {

/// `frame` as it is to be looked at, where Exif says that it lies so: 1 upright, 3 upside down, 6
/// and 8 on a side; 2, 4, 5 and 7 also mirrored.
Frame upright(const Frame& frame, int orientation);
/// The size of that.
Size upright_size(Size size, int orientation);

}  // namespace eyebridge::camera
