#pragma once

#include "image.hpp"
#include "lcd.hpp"

namespace eyebridge::robios {

// The variables that the published header shows to programs. They are plain ints, as programs
// declare them: written by the calls that change them, on the calling thread.

/// Sets IM_LEFT, IM_TOP, IM_WIDTH and IM_LENGTH, and IM_TYPE to `mode`, as after LCDImageSize().
/// CAMInit() calls it after Lcd::follow_camera().
void publish_image_window(const ImageWindow& window, int mode);

/// Sets the size that IP functions work on, and IP_WIDTH and friends. IPSetSize() and CAMInit().
void set_ip_size(ImageSize size);

}  // namespace eyebridge::robios
