#pragma once

#include <filesystem>

#include "eyebridge/camera/frame.hpp"

namespace eyebridge::camera {

/// Writes `frame` as a PNG. Throws std::runtime_error naming the file and the reason.
void write_png(const Frame& frame, const std::filesystem::path& path);

/// Reads an 8-bit PNG (any colour type) as Rgb24. Throws std::runtime_error likewise.
Frame read_png(const std::filesystem::path& path);

}  // namespace eyebridge::camera
