#include "render/textures.hpp"

#include <algorithm>

#include "eyebridge/camera/convert.hpp"

namespace eyebridge::camera {
namespace {

constexpr int kLongestSide = 2048;

/// The level of half the size: boxes of about 2 x 2 pixels, every source pixel in exactly one box.
TextureLevel halved(const TextureLevel& from) {
  TextureLevel to{std::max(1, from.width / 2), std::max(1, from.height / 2), {}};
  to.rgba.reserve(static_cast<std::size_t>(to.width) * static_cast<std::size_t>(to.height) * 4);
  for (int y = 0; y < to.height; ++y) {
    for (int x = 0; x < to.width; ++x) {
      int sum[4] = {};
      int count = 0;
      for (int v = y * from.height / to.height; v < (y + 1) * from.height / to.height; ++v) {
        for (int u = x * from.width / to.width; u < (x + 1) * from.width / to.width; ++u) {
          const std::size_t at = static_cast<std::size_t>(v * from.width + u) * 4;
          for (std::size_t c = 0; c < 4; ++c) sum[c] += from.rgba[at + c];
          ++count;
        }
      }
      for (const int s : sum) {
        to.rgba.push_back(static_cast<std::uint8_t>((s + count / 2) / count));
      }
    }
  }
  return to;
}

}  // namespace

TextureLevel picture_texture(const Frame& picture) {
  const Frame rgb = to_rgb24(picture);
  TextureLevel level{rgb.width, rgb.height, {}};
  level.rgba.reserve(static_cast<std::size_t>(rgb.width) * static_cast<std::size_t>(rgb.height) *
                     4);
  for (int y = rgb.height - 1; y >= 0; --y) {
    const auto row = rgb.row(y);
    for (std::size_t x = 0; x + 2 < row.size(); x += 3) {
      level.rgba.insert(level.rgba.end(), {row[x], row[x + 1], row[x + 2], 255});
    }
  }
  while (std::max(level.width, level.height) > kLongestSide) level = halved(level);
  return level;
}

std::vector<TextureLevel> mip_levels(TextureLevel base) {
  std::vector<TextureLevel> levels;
  levels.push_back(std::move(base));
  while (levels.back().width > 1 || levels.back().height > 1) {
    levels.push_back(halved(levels.back()));
  }
  return levels;
}

}  // namespace eyebridge::camera
