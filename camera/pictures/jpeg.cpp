#include <stdexcept>
#include <string>

#include "pictures/decoders.hpp"
#include "pictures/jpeg_decoder.hpp"
#include "pictures/turn.hpp"

namespace eyebridge::camera {
namespace {

template <class Value>
Value value_or_throw(Result<Value>&& result) {
  if (!result) throw std::runtime_error(result.error().what);
  return std::move(*result);
}

}  // namespace

Size jpeg_size(std::span<const std::uint8_t> bytes) {
  const JpegHeader header = value_or_throw(read_jpeg_header(bytes));
  return upright_size(header.size, header.orientation);
}

Frame decode_jpeg(std::span<const std::uint8_t> bytes, std::uint64_t most_pixels) {
  JpegOptions options;
  options.most_pixels = most_pixels;
  const Frame frame = value_or_throw(decode_jpeg(bytes, options, [&](int width, int height) {
    return frame_to_decode(width, height, most_pixels);
  }));
  return upright(frame, value_or_throw(read_jpeg_header(bytes)).orientation);
}

}  // namespace eyebridge::camera
