#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "eyebridge/camera/frame.hpp"

namespace eyebridge::camera {

/// "eyebridge_decode_picture" of libeyebridge_video.so: fills `rgb`, `width` x `height` x 3 bytes,
/// with the picture in the `size` bytes at `data`. False where it is none, or of another size.
using DecodePicture = bool (*)(const std::uint8_t* data, std::size_t size, int width, int height,
                               std::uint8_t* rgb);

/// The picture in `bytes`, whose header says that it is of `size`. `format` is for messages. Throws
/// std::runtime_error, also where the library cannot be loaded.
Frame decode_by_opencv(std::span<const std::uint8_t> bytes, Size size, const std::string& format,
                       std::uint64_t most_pixels);

}  // namespace eyebridge::camera
