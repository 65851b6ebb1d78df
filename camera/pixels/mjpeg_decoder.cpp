#include "pixels/mjpeg_decoder.hpp"

namespace eyebridge::camera {

Result<Frame> decode_mjpeg(std::span<const std::uint8_t> bytes, Size size, Size least,
                           FramePool& pool) {
  JpegOptions options;
  options.most_pixels =
      static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height);
  options.size = size;
  options.least = least;
  options.is_fast = true;  // of a camera's chroma there is not more to see anyway
  const auto make = [&](int width, int height) {
    return pool.make(width, height, PixelFormat::Rgb24);
  };
  return decode_jpeg(bytes, options, make).map_error([](Error error) {
    error.what = "M" + error.what;
    return error;
  });
}

}  // namespace eyebridge::camera
