#include "eyebridge/camera/png.hpp"

#include <stdexcept>
#include <string>

#include <png.h>

#include "eyebridge/camera/convert.hpp"

namespace eyebridge::camera {
namespace {

// Decoding more would take over a gigabyte; no camera and no floor needs it.
constexpr std::uint64_t kMostPixels = 100'000'000;

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

}  // namespace

void write_png(const Frame& frame, const std::filesystem::path& path) {
  Image image;
  image.width = static_cast<png_uint_32>(frame.width);
  image.height = static_cast<png_uint_32>(frame.height);
  image.format = png_format(frame.format);
  if (png_image_write_to_file(&image, path.c_str(), /*convert_to_8bit=*/0, frame.bytes.data(),
                              frame.stride, /*colormap=*/nullptr) == 0) {
    fail_with(path, std::string("cannot write PNG: ") + image.message);
  }
}

Frame read_png(const std::filesystem::path& path) {
  Image image;
  if (png_image_begin_read_from_file(&image, path.c_str()) == 0) {
    fail_with(path, std::string("cannot read PNG: ") + image.message);
  }
  if (std::uint64_t{image.width} * image.height > kMostPixels) {
    fail_with(path, "cannot read PNG: " + std::to_string(image.width) + " x " +
                        std::to_string(image.height) + " pixels, at most " +
                        std::to_string(kMostPixels) + " are read");
  }
  image.format = PNG_FORMAT_RGB;
  Frame frame =
      make_frame(static_cast<int>(image.width), static_cast<int>(image.height), PixelFormat::Rgb24);
  const png_color white{255, 255, 255};  // behind transparent pixels
  if (png_image_finish_read(&image, &white, frame.bytes.data(), frame.stride, nullptr) == 0) {
    fail_with(path, std::string("cannot read PNG: ") + image.message);
  }
  return frame;
}

}  // namespace eyebridge::camera
