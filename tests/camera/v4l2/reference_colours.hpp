#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace eyebridge::camera::testing {

using Pixel = std::array<std::uint8_t, 3>;

/// A pixel of BT.601 (Y of 16 ... 235, U and V of 16 ... 240) as R, G, B, in steps of 1/64 as
/// SIMD code counts: written here anew, one pixel at a time, to be compared exactly.
inline Pixel reference_rgb(int y, int u, int v) {
  // 255 / 219 in 1/64, of Y spread to 16 bits, and 16 of black with half a step for rounding.
  const int light = (y * 257 * 18997 >> 16) - 1160;
  const auto byte = [](int sixty_fourths) {
    return static_cast<std::uint8_t>(std::clamp(sixty_fourths >> 6, 0, 255));
  };
  // 1.596, 0.391 and 0.813, 2.018 (at most 2, in signed bytes).
  return {byte(light + 102 * (v - 128)), byte(light - 25 * (u - 128) - 52 * (v - 128)),
          byte(light + 128 * (u - 128))};
}

/// The same by the definition of BT.601.
inline std::array<double, 3> true_rgb(int y, int u, int v) {
  const double light = 255.0 / 219.0 * (y - 16);
  const double blue = 255.0 / 224.0 * (u - 128);
  const double red = 255.0 / 224.0 * (v - 128);
  const auto clamped = [](double value) { return std::clamp(value, 0.0, 255.0); };
  return {clamped(light + 1.402 * red), clamped(light - 0.344136 * blue - 0.714136 * red),
          clamped(light + 1.772 * blue)};
}

/// R, G, B of a whole YUYV picture of even width.
inline std::vector<std::uint8_t> reference_of_yuyv(const std::vector<std::uint8_t>& yuyv) {
  std::vector<std::uint8_t> out;
  out.reserve(yuyv.size() / 2 * 3);
  for (std::size_t i = 0; i + 3 < yuyv.size(); i += 4) {
    for (const std::size_t y : {i, i + 2}) {
      const Pixel pixel = reference_rgb(yuyv[y], yuyv[i + 1], yuyv[i + 3]);
      out.insert(out.end(), pixel.begin(), pixel.end());
    }
  }
  return out;
}

/// Peak signal-to-noise ratio of two pictures of bytes, dB.
inline double psnr(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
  if (a.size() != b.size() || a.empty()) return 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::pow(static_cast<double>(a[i]) - b[i], 2);
  if (sum == 0.0) return 1e9;
  return 10.0 * std::log10(255.0 * 255.0 * static_cast<double>(a.size()) / sum);
}

}  // namespace eyebridge::camera::testing
