#include "frames/opencv_decoder.hpp"

#include <stdexcept>

#include "eyebridge/base/config_error.hpp"
#include "pictures/decoders.hpp"
#include "sources/own_library.hpp"

namespace eyebridge::camera {
namespace {

DecodePicture loaded_decoder(const std::string& format) {
  try {
    return reinterpret_cast<DecodePicture>(
        own_library_entry("libeyebridge_video.so", "eyebridge_decode_picture"));
  } catch (const ConfigError& error) {
    throw std::runtime_error(format + ": " + error.text());
  }
}

}  // namespace

Frame decode_by_opencv(std::span<const std::uint8_t> bytes, Size size, const std::string& format,
                       std::uint64_t most_pixels) {
  Frame frame = frame_to_decode(size.width, size.height, most_pixels);
  const DecodePicture decode = loaded_decoder(format);
  if (!decode(bytes.data(), bytes.size(), size.width, size.height, frame.bytes.data())) {
    throw std::runtime_error(format + ": cut, damaged, or of a kind that OpenCV does not decode");
  }
  return frame;
}

}  // namespace eyebridge::camera
