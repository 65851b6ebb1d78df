#include <stdexcept>
#include <string_view>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/pnm.hpp"
#include "pictures/decoders.hpp"

namespace eyebridge::camera {
namespace {

PnmPicture read(std::span<const std::uint8_t> bytes, std::uint64_t most_pixels) {
  try {
    return read_pnm({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, "PNM",
                    most_pixels);
  } catch (const ConfigError& error) {
    throw std::runtime_error("PNM: " + error.text());
  }
}

}  // namespace

Frame decode_pnm(std::span<const std::uint8_t> bytes, std::uint64_t most_pixels) {
  const PnmPicture picture = read(bytes, most_pixels);
  Frame frame = frame_to_decode(picture.columns, picture.rows, most_pixels);
  if (picture.kind == PnmKind::Colour) {
    frame.bytes = picture.bytes;
    return frame;
  }
  std::uint8_t* to = frame.bytes.data();
  for (const std::uint8_t value : picture.bytes) {
    const auto grey = static_cast<std::uint8_t>(picture.kind == PnmKind::Grey ? value
                                                : value != 0                  ? 0
                                                                              : 255);
    for (int channel = 0; channel < 3; ++channel) *to++ = grey;
  }
  return frame;
}

// The header is short, but the reader has no way to stop after it.
Size pnm_size(std::span<const std::uint8_t> bytes) {
  const PnmPicture picture = read(bytes, 1U << 30U);
  return {picture.columns, picture.rows};
}

}  // namespace eyebridge::camera
