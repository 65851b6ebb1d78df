#include "eyebridge/camera/png.hpp"

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdio>
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

/// libpng's reader, whose errors jump here instead of ending the process. What it lives in holds
/// nothing that a jump would leave behind.
struct PngReader {
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::span<const std::uint8_t> rest;
  std::array<char, 120> message{};

  PngReader() = default;
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
};

void take_bytes(png_structp png, png_bytep to, png_size_t count) {
  auto& reader = *static_cast<PngReader*>(png_get_io_ptr(png));
  if (count > reader.rest.size()) png_error(png, "the file ends too early");
  std::copy_n(reader.rest.begin(), count, to);
  reader.rest = reader.rest.subspan(count);
}

void on_png_error(png_structp png, png_const_charp text) {
  auto& reader = *static_cast<PngReader*>(png_get_error_ptr(png));
  std::snprintf(reader.message.data(), reader.message.size(), "%s", text);
  png_longjmp(png, 1);
}

/// False: it failed.
bool read_png_header(PngReader& reader) {
  reader.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reader, on_png_error,
                                      [](png_structp, png_const_charp) {});
  if (reader.png == nullptr) return false;
  if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
  reader.info = png_create_info_struct(reader.png);
  png_set_read_fn(reader.png, &reader, take_bytes);
  png_read_info(reader.png, reader.info);
  return true;
}

/// As Rgb24: 16 bits as the upper 8, what is transparent on white. False: it failed.
bool read_png_pixels(PngReader& reader, Frame& frame) {
  if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
  png_set_expand(reader.png);
  png_set_scale_16(reader.png);
  png_set_gray_to_rgb(reader.png);
  png_color_16 white{};
  white.red = white.green = white.blue = white.gray = 255;
  png_set_background(reader.png, &white, PNG_BACKGROUND_GAMMA_SCREEN, 0, 1.0);
  const int passes = png_set_interlace_handling(reader.png);
  png_read_update_info(reader.png, reader.info);
  if (png_get_rowbytes(reader.png, reader.info) != static_cast<std::size_t>(frame.stride)) {
    png_error(reader.png, "its pixels are not of three colours");
  }
  for (int pass = 0; pass < passes; ++pass) {
    for (int row = 0; row < frame.height; ++row) {
      png_read_row(reader.png,
                   frame.bytes.data() +
                       static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.stride),
                   nullptr);
    }
  }
  png_read_end(reader.png, nullptr);
  return true;
}

[[noreturn]] void fail_with(const PngReader& reader) {
  throw std::runtime_error(std::string("PNG: ") + reader.message.data());
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

Frame read_png(const std::filesystem::path& path) { return read_picture(path); }

Frame decode_png(std::span<const std::uint8_t> bytes, std::uint64_t most_pixels) {
  PngReader reader;
  reader.rest = bytes;
  if (!read_png_header(reader)) fail_with(reader);
  Frame frame = frame_to_decode(png_get_image_width(reader.png, reader.info),
                                png_get_image_height(reader.png, reader.info), most_pixels);
  if (!read_png_pixels(reader, frame)) fail_with(reader);
  return frame;
}

Size png_size(std::span<const std::uint8_t> bytes) {
  PngReader reader;
  reader.rest = bytes;
  if (!read_png_header(reader)) fail_with(reader);
  return {static_cast<int>(png_get_image_width(reader.png, reader.info)),
          static_cast<int>(png_get_image_height(reader.png, reader.info))};
}

}  // namespace eyebridge::camera
