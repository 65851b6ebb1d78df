#pragma once

#include <cstdint>
#include <span>

namespace eyebridge::camera {

/// The orientation, 1 ... 8, that an APP1 marker of a JPEG says (CIPA DC-008, Exif 2.32); 0: none.
int exif_orientation(std::span<const std::uint8_t> marker);

}  // namespace eyebridge::camera
