#include "stb_picture.hpp"

#include <cstdint>
#include <memory>

// The kinds that maps have, from memory alone: less code that meets hostile bytes.
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_ONLY_BMP
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace eyebridge::files {
namespace {

/// Whether all parts of a PNG are there: stb_image takes as much memory as a part says it has.
bool is_whole_png(std::string_view bytes) {
  constexpr std::size_t kSignature = 8;
  constexpr std::size_t kAround = 12;  // length, name, check sum
  for (std::size_t at = kSignature; at + kAround <= bytes.size();) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      length = length << 8U | static_cast<unsigned char>(bytes[at + i]);
    }
    if (length > bytes.size() - at - kAround) return false;
    if (bytes.substr(at + 4, 4) == "IEND") return true;
    at += length + kAround;
  }
  return false;
}

}  // namespace

GreyPicture read_stb_picture(std::string_view bytes, const std::string& file,
                             std::size_t most_pixels) {
  const auto* const data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(bytes.size());  // at most kMaxFileSize
  const auto refuse = [&file](const std::string& why) { throw ConfigError({file, 0, 0}, why); };
  if (bytes.starts_with("\x89PNG") && !is_whole_png(bytes)) {
    refuse("a PNG that ends too early: expected a whole file");
  }
  int columns = 0;
  int rows = 0;
  int channels = 0;
  if (stbi_info_from_memory(data, size, &columns, &rows, &channels) == 0) {
    refuse(std::string("a picture that cannot be decoded: ") + stbi_failure_reason());
  }
  if (columns < 1 || rows < 1 ||
      static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows) > most_pixels) {
    refuse("picture of " + std::to_string(columns) + " x " + std::to_string(rows) +
           " pixels: expected at most " + std::to_string(most_pixels));
  }
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(data, size, &columns, &rows, &channels, 0), stbi_image_free);
  if (!pixels) refuse(std::string("a picture that cannot be decoded: ") + stbi_failure_reason());
  GreyPicture out{columns, rows, {}};
  const std::size_t count = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  out.greys.reserve(count);
  const int colours = channels >= 3 ? 3 : 1;
  for (std::size_t i = 0; i < count; ++i) {
    const stbi_uc* const pixel = pixels.get() + i * static_cast<std::size_t>(channels);
    int sum = 0;
    for (int k = 0; k < colours; ++k) sum += pixel[k];
    int grey = sum / colours;
    if (channels > colours) {
      const int alpha = pixel[colours];
      grey = (grey * alpha + 255 * (255 - alpha)) / 255;
    }
    out.greys.push_back(static_cast<std::uint8_t>(grey));
  }
  return out;
}

}  // namespace eyebridge::files
