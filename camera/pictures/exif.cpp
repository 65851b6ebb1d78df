#include "pictures/exif.hpp"

#include <algorithm>
#include <array>

namespace eyebridge::camera {
namespace {

constexpr std::array<std::uint8_t, 6> kExifMark = {'E', 'x', 'i', 'f', 0, 0};
constexpr std::uint32_t kOrientationTag = 0x0112;
constexpr std::size_t kEntry = 12;  // bytes

/// Numbers in a TIFF structure, which says its own byte order.
class Tiff {
 public:
  explicit Tiff(std::span<const std::uint8_t> bytes)
      : bytes_(bytes), is_little_(!bytes.empty() && bytes[0] == 'I') {}

  [[nodiscard]] bool has(std::size_t at, std::size_t count) const {
    return at <= bytes_.size() && count <= bytes_.size() - at;
  }
  /// Of `count` bytes, which are there.
  [[nodiscard]] std::uint32_t number(std::size_t at, std::size_t count) const {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < count; ++i) {
      value = value << 8U | bytes_[at + (is_little_ ? count - 1 - i : i)];
    }
    return value;
  }

 private:
  std::span<const std::uint8_t> bytes_;
  bool is_little_;
};

}  // namespace

int exif_orientation(std::span<const std::uint8_t> marker) {
  if (marker.size() < kExifMark.size() ||
      !std::ranges::equal(marker.first(kExifMark.size()), kExifMark)) {
    return 0;
  }
  const Tiff tiff(marker.subspan(kExifMark.size()));
  if (!tiff.has(0, 8)) return 0;
  const std::size_t directory = tiff.number(4, 4);
  if (!tiff.has(directory, 2)) return 0;
  const std::size_t entries = tiff.number(directory, 2);
  for (std::size_t i = 0; i < entries; ++i) {
    const std::size_t at = directory + 2 + i * kEntry;
    if (!tiff.has(at, kEntry)) return 0;
    if (tiff.number(at, 2) != kOrientationTag) continue;
    const std::uint32_t value = tiff.number(at + 8, 2);
    return value >= 1 && value <= 8 ? static_cast<int>(value) : 0;
  }
  return 0;
}

}  // namespace eyebridge::camera
