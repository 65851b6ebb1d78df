#pragma once

#include "eyebridge/camera/frame.hpp"

namespace eyebridge::camera {

// Time and sequence of a frame are kept by all of these.

/// An empty picture: rows without padding, all bytes 0. Sizes of at least 1.
Frame make_frame(int width, int height, PixelFormat format);
/// The same in `memory`, which is resized; what is in it stays.
Frame make_frame(int width, int height, PixelFormat format, std::vector<std::uint8_t>&& memory);

/// `frame` as Rgb24. Grey becomes R = G = B; alpha is dropped.
Frame to_rgb24(const Frame& frame);

/// `frame` as Grey8: (R + G + B) / 3, rounded down, as RoBIOS' IPCol2Gray does.
Frame to_grey8(const Frame& frame);

/// `frame` as a picture of `width` x `height` pixels: cut about its middle to that aspect, then
/// each new pixel is the mean of the box that it covers (the nearest pixel when it is enlarged).
Frame fit(const Frame& frame, int width, int height);
/// The same; costs nothing when it has that size already.
Frame fit(Frame&& frame, int width, int height);

}  // namespace eyebridge::camera
