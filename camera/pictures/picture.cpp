#include "eyebridge/camera/picture.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "eyebridge/base/read_file.hpp"
#include "eyebridge/camera/convert.hpp"
#include "pictures/decoders.hpp"

namespace eyebridge::camera {
namespace {

struct Format {
  std::string_view first_bytes;
  Frame (*decode)(std::span<const std::uint8_t> bytes, std::uint64_t most_pixels);
  Size (*size)(std::span<const std::uint8_t> bytes);
};

constexpr auto kPictureFormats = std::to_array<Format>({
    {"\x89PNG\r\n\x1A\n", &decode_png, &png_size},
    {"\xFF\xD8\xFF", &decode_jpeg, &jpeg_size},
    {"BM", &decode_bmp, &bmp_size},
    {"P1", &decode_pnm, &pnm_size},
    {"P2", &decode_pnm, &pnm_size},
    {"P3", &decode_pnm, &pnm_size},
    {"P4", &decode_pnm, &pnm_size},
    {"P5", &decode_pnm, &pnm_size},
    {"P6", &decode_pnm, &pnm_size},
    {{"II*\0", 4}, &decode_tiff, &tiff_size},
    {{"MM\0*", 4}, &decode_tiff, &tiff_size},
    {"RIFF", &decode_webp, &webp_size},
});

/// The largest picture, uncompressed, with room for a header.
constexpr std::uint64_t kMostBytes = 4 * kMostPicturePixels;

std::vector<std::uint8_t> read_bytes(const std::filesystem::path& path) {
  const auto bytes = eyebridge::read_file(path, kMostBytes);
  if (!bytes) throw std::runtime_error(bytes.error().what);
  return {bytes->begin(), bytes->end()};
}

/// The format that `bytes` are in. Throws when it is none of ours.
const Format& format_of(std::span<const std::uint8_t> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  for (const Format& format : kPictureFormats) {
    if (text.starts_with(format.first_bytes)) return format;
  }
  throw std::runtime_error("no picture: expected PNG, JPEG, BMP, PGM, PPM, TIFF or WebP");
}

/// What `read` makes of the file's bytes; its failure names the file.
template <class Read>
auto read_file(const std::filesystem::path& path, const Read& read) {
  try {
    return read(read_bytes(path));
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path.string() + ": cannot read picture: " + error.what());
  }
}

}  // namespace

Frame frame_to_decode(std::int64_t width, std::int64_t height, std::uint64_t most_pixels) {
  // First each side alone: their product must not overflow.
  const auto most = static_cast<std::int64_t>(std::min<std::uint64_t>(most_pixels, 1U << 30U));
  if (width < 1 || height < 1 || width > most || height > most || width * height > most) {
    throw std::runtime_error(std::to_string(width) + " x " + std::to_string(height) +
                             " pixels, expected 1 ... " + std::to_string(most));
  }
  return make_frame(static_cast<int>(width), static_cast<int>(height), PixelFormat::Rgb24);
}

Frame decode_picture(std::span<const std::uint8_t> bytes, std::uint64_t most_pixels) {
  return format_of(bytes).decode(bytes, most_pixels);
}

Frame read_picture(const std::filesystem::path& path) {
  return read_file(path, [](const auto& bytes) { return decode_picture(bytes); });
}

Size picture_size(const std::filesystem::path& path) {
  return read_file(path, [](const auto& bytes) { return format_of(bytes).size(bytes); });
}

}  // namespace eyebridge::camera
