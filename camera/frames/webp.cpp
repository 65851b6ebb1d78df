#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "frames/opencv_decoder.hpp"
#include "pictures/decoders.hpp"

// Sizes: RFC 9649, WebP container and bitstreams.
namespace eyebridge::camera {
namespace {

constexpr std::size_t kFirstChunk = 12;
constexpr std::size_t kLeast = 30;  // bytes that all three kinds have

std::uint32_t number(std::span<const std::uint8_t> bytes, std::size_t at, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = count; i-- > 0;) value = value << 8U | bytes[at + i];
  return value;
}

bool has(std::span<const std::uint8_t> bytes, std::size_t at, std::string_view text) {
  return std::equal(text.begin(), text.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at));
}

}  // namespace

Size webp_size(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kLeast || !has(bytes, 8, "WEBP")) {
    throw std::runtime_error("WebP: no complete header");
  }
  const auto size = [](std::uint32_t width, std::uint32_t height) {
    return Size{static_cast<int>(width), static_cast<int>(height)};
  };
  constexpr std::uint32_t kFourteenBits = 0x3FFF;
  if (has(bytes, kFirstChunk, "VP8X")) {
    return size(number(bytes, 24, 3) + 1, number(bytes, 27, 3) + 1);
  }
  if (has(bytes, kFirstChunk, "VP8L")) {
    const std::uint32_t bits = number(bytes, 21, 4);
    return size((bits & kFourteenBits) + 1, (bits >> 14U & kFourteenBits) + 1);
  }
  if (has(bytes, kFirstChunk, "VP8 ")) {
    return size(number(bytes, 26, 2) & kFourteenBits, number(bytes, 28, 2) & kFourteenBits);
  }
  throw std::runtime_error("WebP: no picture in it");
}

Frame decode_webp(std::span<const std::uint8_t> bytes, std::uint64_t most_pixels) {
  return decode_by_opencv(bytes, webp_size(bytes), "WebP", most_pixels);
}

}  // namespace eyebridge::camera
