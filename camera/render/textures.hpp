#pragma once

#include <cstdint>
#include <vector>

#include "eyebridge/camera/frame.hpp"

namespace eyebridge::camera {

/// One level of a texture, RGBA, 8 bits a channel.
struct TextureLevel {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

/// A picture as a texture, first row at v = 1; longer sides than 2048 pixels are averaged down.
TextureLevel picture_texture(const Frame& picture);

/// All levels from `base` down to one pixel, each the mean of the one before over boxes.
///
/// By hand: glGenerateMipmap costs 55-110 ms a context, as Mesa compiles shaders for it.
std::vector<TextureLevel> mip_levels(TextureLevel base);

}  // namespace eyebridge::camera
