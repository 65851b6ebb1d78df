#include <stdexcept>
#include <string>

#include "frames/opencv_decoder.hpp"
#include "pictures/decoders.hpp"
#include "pictures/turn.hpp"

// Sizes: Adobe, TIFF revision 6.0, sections 2 and 8.
namespace eyebridge::camera {
namespace {

constexpr std::uint32_t kWidth = 256;
constexpr std::uint32_t kLength = 257;
constexpr std::uint32_t kOrientation = 274;
constexpr std::uint32_t kShort = 3;  // the types that a size may have
constexpr std::uint32_t kLong = 4;
constexpr std::size_t kEntry = 12;  // bytes

class Tiff {
 public:
  explicit Tiff(std::span<const std::uint8_t> bytes)
      : bytes_(bytes), is_little_(!bytes.empty() && bytes[0] == 'I') {}

  [[nodiscard]] std::uint32_t number(std::uint64_t at, std::size_t count) const {
    if (at > bytes_.size() || count > bytes_.size() - at) {
      throw std::runtime_error("TIFF: the file is cut");
    }
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t k = is_little_ ? count - 1 - i : i;
      value = value << 8U | bytes_[static_cast<std::size_t>(at) + k];
    }
    return value;
  }
  /// What the first directory says of `tag`; `otherwise` where it does not.
  [[nodiscard]] std::uint32_t value(std::uint32_t tag, std::uint32_t otherwise) const {
    const std::uint64_t directory = number(4, 4);
    const std::uint32_t entries = number(directory, 2);
    for (std::uint32_t i = 0; i < entries; ++i) {
      const std::uint64_t entry = directory + 2 + std::uint64_t{kEntry} * i;
      if (number(entry, 2) != tag) continue;
      const std::uint32_t type = number(entry + 2, 2);
      if (type == kShort) return number(entry + 8, 2);
      if (type == kLong) return number(entry + 8, 4);
    }
    return otherwise;
  }

 private:
  std::span<const std::uint8_t> bytes_;
  bool is_little_;
};

}  // namespace

Size tiff_size(std::span<const std::uint8_t> bytes) {
  const Tiff file(bytes);
  const std::uint32_t width = file.value(kWidth, 0);
  const std::uint32_t height = file.value(kLength, 0);
  constexpr std::uint32_t kMost = 1U << 30U;
  if (width < 1 || height < 1 || width > kMost || height > kMost) {
    throw std::runtime_error("TIFF: " + std::to_string(width) + " x " + std::to_string(height) +
                             " pixels, expected at least 1 x 1");
  }
  return upright_size({static_cast<int>(width), static_cast<int>(height)},
                      static_cast<int>(file.value(kOrientation, 1) & 0xFU));
}

Frame decode_tiff(std::span<const std::uint8_t> bytes, std::uint64_t most_pixels) {
  return decode_by_opencv(bytes, tiff_size(bytes), "TIFF", most_pixels);
}

}  // namespace eyebridge::camera
