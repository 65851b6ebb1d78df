#pragma once

#include "eyebridge/camera/frame.hpp"
#include "golden.hpp"

namespace eyebridge::gallery {

/// A picture of the LCD in letters, one for each 8 x 16 pixels (2 x 4 of a small one): '.' is the
/// background, the most frequent colour, otherwise the nearest named colour that covers most of
/// what is not background there, small when it covers less than half of the cell. A last line tells
/// the letters that were used. Rgb24.
Lines lcd_cells(const camera::Frame& lcd);

/// FNV-1a of the picture's bytes, 16 hexadecimal digits.
std::string hash_of(const camera::Frame& picture);

}  // namespace eyebridge::gallery
