#pragma once

#include <string>

#include "eyebridge/camera/frame.hpp"

namespace eyebridge::apps {

/// `frame` (Rgb24) as text for a terminal with 24-bit colours: half blocks, two pixels a character,
/// at most `columns` wide and `rows` high; each at least 1.
std::string terminal_picture(const camera::Frame& frame, int columns, int rows);

}  // namespace eyebridge::apps
