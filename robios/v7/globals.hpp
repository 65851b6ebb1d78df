#pragma once

#include "image.hpp"
#include "lcd.hpp"

namespace eyebridge::robios {

// The variables that the published header shows to programs. They are plain ints, as programs
// declare them: written by the calls that change them, on the calling thread.

/// The variable NAME of the header as the calling thread's robot has it: one of several robots sees
/// its program's copy, or one that nobody else uses.
#define EYEBRIDGE_VARIABLE(NAME) ::eyebridge::robios::shown(::NAME, #NAME)

/// What EYEBRIDGE_VARIABLE stands for; `ours` is the process's, `name` a literal.
int& shown(int& ours, const char* name);

/// Sets IM_LEFT, IM_TOP, IM_WIDTH and IM_LENGTH, and IM_TYPE to `mode`, as after LCDImageSize().
/// CAMInit() calls it after Lcd::follow_camera().
void publish_image_window(const ImageWindow& window, int mode);

/// Sets the size that IP functions work on, and IP_WIDTH and friends. IPSetSize() and CAMInit().
void set_ip_size(ImageSize size);

}  // namespace eyebridge::robios
