#pragma once

#include <QImage>

#include "eyebridge/camera/frame.hpp"

namespace eyebridge::gui {

/// A copy of the frame, of any format.
QImage image_of(const camera::Frame& frame);

}  // namespace eyebridge::gui
