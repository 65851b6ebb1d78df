#include "optics/undistortion.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "eyebridge/camera/convert.hpp"
#include "optics/lens_distortion.hpp"

namespace eyebridge::camera {
namespace {

constexpr std::uint32_t kOne = 128;  ///< Two factors of it, times a byte, fit into 32 bits.

}  // namespace

Undistortion::Undistortion(const Calibration& lens) : size_(lens.size) {
  looks_.reserve(static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(size_.height));
  for (int y = 0; y < size_.height; ++y) {
    for (int x = 0; x < size_.width; ++x) {
      const Vec2 pixel{static_cast<double>(x), static_cast<double>(y)};
      const Vec2 from = to_pixel(lens, distorted(lens, to_plane(lens, pixel)));
      Look look;
      // Within half a pixel of the border the border's own value is as good.
      if (from.x > -0.5 && from.y > -0.5 && from.x < size_.width - 0.5 &&
          from.y < size_.height - 0.5) {
        const double left = std::clamp(std::floor(from.x), 0.0, std::max(size_.width - 2.0, 0.0));
        const double top = std::clamp(std::floor(from.y), 0.0, std::max(size_.height - 2.0, 0.0));
        const auto part = [](double value) {
          return static_cast<std::uint16_t>(std::lround(std::clamp(value, 0.0, 1.0) * kOne));
        };
        look = {static_cast<std::int32_t>(top) * size_.width + static_cast<std::int32_t>(left),
                part(from.x - left), part(from.y - top)};
      }
      looks_.push_back(look);
    }
  }
}

Frame Undistortion::apply(const Frame& frame) const {
  assert((size_ == Size{frame.width, frame.height}));
  Frame out = make_frame(size_.width, size_.height, frame.format);
  out.time = frame.time;
  out.sequence = frame.sequence;
  out.odd = frame.odd;
  const auto bytes = static_cast<std::size_t>(bytes_per_pixel(frame.format));
  const auto stride = static_cast<std::size_t>(frame.stride);
  const auto width = static_cast<std::size_t>(size_.width);
  const std::size_t next = size_.width > 1 ? bytes : 0;
  const std::size_t below = size_.height > 1 ? stride : 0;
  std::uint8_t* to = out.bytes.data();
  for (const Look& look : looks_) {
    if (look.pixel < 0) {
      to += bytes;
      continue;
    }
    const auto pixel = static_cast<std::size_t>(look.pixel);
    const std::uint8_t* from =
        frame.bytes.data() + (pixel / width) * stride + (pixel % width) * bytes;
    const std::uint32_t right = look.right;
    const std::uint32_t left = kOne - right;
    const std::uint32_t lower = look.lower;
    const std::uint32_t upper = kOne - lower;
    for (std::size_t i = 0; i < bytes; ++i, ++from) {
      const std::uint32_t sum = upper * (left * from[0] + right * from[next]) +
                                lower * (left * from[below] + right * from[below + next]);
      *to++ = static_cast<std::uint8_t>((sum + kOne * kOne / 2) / (kOne * kOne));
    }
  }
  return out;
}

}  // namespace eyebridge::camera
