#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "eyebridge/files/map_files.hpp"

namespace eyebridge::files {

/// Decodes a PNG or BMP by stb_image: the mean of red, green and blue; what is transparent is as it
/// would be on white paper. Throws ConfigError, also for more than `most_pixels`.
GreyPicture read_stb_picture(std::string_view bytes, const std::string& file,
                             std::size_t most_pixels);

}  // namespace eyebridge::files
