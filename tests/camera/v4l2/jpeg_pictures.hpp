#pragma once

#include <cstdint>
#include <vector>

#include <turbojpeg.h>

namespace eyebridge::camera::testing {

/// A smooth picture, R, G, B: what JPEG is made for. Each `number` gives another.
inline std::vector<std::uint8_t> smooth_picture(int width, int height, int number = 0) {
  std::vector<std::uint8_t> out;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      out.push_back(static_cast<std::uint8_t>((40 + x * 160 / width + 7 * number) % 256));
      out.push_back(static_cast<std::uint8_t>(60 + y * 140 / height));
      out.push_back(static_cast<std::uint8_t>(200 - (x + y) * 120 / (width + height)));
    }
  }
  return out;
}

/// `rgb` as a JPEG.
inline std::vector<std::uint8_t> jpeg_of(const std::vector<std::uint8_t>& rgb, int width,
                                         int height, int quality = 95,
                                         int subsampling = TJSAMP_422) {
  void* encoder = tjInitCompress();
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  tjCompress2(encoder, rgb.data(), width, 0, height, TJPF_RGB, &bytes, &size, subsampling, quality,
              0);
  std::vector<std::uint8_t> out(bytes, bytes + size);
  tjFree(bytes);
  tjDestroy(encoder);
  return out;
}

/// `jpeg` without its Huffman tables (markers FF C4), which many cameras leave out.
inline std::vector<std::uint8_t> without_tables(std::vector<std::uint8_t> jpeg) {
  for (std::size_t at = 2; at + 4 < jpeg.size() && jpeg[at + 1] != 0xDA;) {
    const std::size_t length = 2U + (unsigned{jpeg[at + 2]} << 8U | jpeg[at + 3]);
    if (jpeg[at + 1] == 0xC4) {
      jpeg.erase(jpeg.begin() + static_cast<std::ptrdiff_t>(at),
                 jpeg.begin() + static_cast<std::ptrdiff_t>(at + length));
    } else {
      at += length;
    }
  }
  return jpeg;
}

}  // namespace eyebridge::camera::testing
