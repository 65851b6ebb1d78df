#include "eyebridge/camera/png.hpp"

#include <stdexcept>
#include <string>

#include <png.h>

#include "eyebridge/base/own_results.hpp"
#include "eyebridge/base/write_file.hpp"
#include "eyebridge/camera/picture.hpp"
#include "pictures/decoders.hpp"

namespace eyebridge::camera {
namespace {

/// Frees what libpng's simplified interface allocates, on every way out.
struct Image : png_image {
  Image() : png_image{} { version = PNG_IMAGE_VERSION; }
  Image(const Image&) = delete;
  Image& operator=(const Image&) = delete;
  ~Image() { png_image_free(this); }
};

[[noreturn]] void fail_with(const std::filesystem::path& path, const std::string& reason) {
  throw std::runtime_error(path.string() + ": " + reason);
}

png_uint_32 png_format(PixelFormat format) {
  switch (format) {
    case PixelFormat::Rgb24:
      return PNG_FORMAT_RGB;
    case PixelFormat::Bgra32:
      return PNG_FORMAT_BGRA;
    case PixelFormat::Grey8:
      break;
  }
  return PNG_FORMAT_GRAY;
}

[[noreturn]] void fail_with(const Image& image) {
  throw std::runtime_error(std::string("PNG: ") + image.message);
}

/// The picture whose header has been read.
Frame finish_reading(Image& image, std::uint64_t most_pixels) {
  Frame frame = frame_to_decode(image.width, image.height, most_pixels);
  image.format = PNG_FORMAT_RGB;
  const png_color white{255, 255, 255};  // behind transparent pixels
  if (png_image_finish_read(&image, &white, frame.bytes.data(), frame.stride, nullptr) == 0) {
    fail_with(image);
  }
  return frame;
}

}  // namespace

void write_png(const Frame& frame, const std::filesystem::path& path) {
  check_replaceable(path, "picture", "\x89PNG");
  Image image;
  image.width = static_cast<png_uint_32>(frame.width);
  image.height = static_cast<png_uint_32>(frame.height);
  image.format = png_format(frame.format);
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&image, bytes.data(), &size, /*convert_to_8bit=*/0,
                                frame.bytes.data(), frame.stride, /*colormap=*/nullptr) == 0) {
    fail_with(path, std::string("cannot write PNG: ") + image.message);
  }
  bytes.resize(size);
  if (const auto done = write_file(path, bytes); !done) fail_with(path, done.error().what);
}

Frame read_png(const std::filesystem::path& path) {
  Image image;
  try {
    if (png_image_begin_read_from_file(&image, path.c_str()) == 0) fail_with(image);
    return finish_reading(image, kMostPicturePixels);
  } catch (const std::runtime_error& error) {
    fail_with(path, std::string("cannot read ") + error.what());
  }
}

Frame decode_png(std::span<const std::uint8_t> bytes, std::uint64_t most_pixels) {
  Image image;
  if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0) fail_with(image);
  return finish_reading(image, most_pixels);
}

Size png_size(std::span<const std::uint8_t> bytes) {
  Image image;
  if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0) fail_with(image);
  return {static_cast<int>(image.width), static_cast<int>(image.height)};
}

}  // namespace eyebridge::camera
