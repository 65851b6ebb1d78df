#pragma once

#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "eyebridge/base/config_error.hpp"
#include "pixels/pixel_decoder.hpp"
#include "v4l2/camera_url.hpp"

// What is done with one input to the readers of live cameras.
namespace eyebridge::fuzz {

/// Six bytes say what the others are: format, size of the stream, size asked for (each side in
/// steps of 3), padding of a row. Accepted frames are as large as asked.
inline void camera_frame(std::string_view text) {
  constexpr std::size_t kHead = 6;
  if (text.size() < kHead) return;
  const auto at = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const auto side = [&](std::size_t i) { return 1 + at(i) * 3; };
  camera::RawPicture picture;
  picture.format = static_cast<camera::RawFormat>(at(0) % 5);
  picture.size = {side(1), side(2)};
  picture.stride = at(5) == 0 ? 0 : side(1) * at(5) / 64;
  const camera::Size size{side(3), side(4)};
  camera::PixelDecoder decoder;
  picture.bytes = {reinterpret_cast<const std::uint8_t*>(text.data()) + kHead, text.size() - kHead};
  const auto frame = decoder.decode(picture, size);
  if (!frame) {
    if (frame.error().code != Errc::Corrupt || frame.error().what.empty()) std::abort();
    return;
  }
  const std::size_t pixels =
      static_cast<std::size_t>(size.width) * static_cast<unsigned>(size.height);
  if (frame->width != size.width || frame->height != size.height ||
      frame->bytes.size() != 3 * pixels) {
    std::abort();
  }
}

/// What follows "v4l2:"; what is accepted is within its limits.
inline void camera_url(std::string_view text) {
  try {
    const camera::CameraUrl url = camera::parse_camera_url(text);
    if (url.fps && !(*url.fps > 0.0 && *url.fps <= 1000.0)) std::abort();
    if (url.size && (url.size->width < 1 || url.size->height < 1 || url.size->width > 4096 ||
                     url.size->height > 4096)) {
      std::abort();
    }
  } catch (const ConfigError&) {  // the input is no camera's URL
  }
}

}  // namespace eyebridge::fuzz
