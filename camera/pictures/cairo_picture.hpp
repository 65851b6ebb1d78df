#pragma once

#include <cairo.h>

#include "eyebridge/camera/convert.hpp"

namespace eyebridge::camera {

/// What was drawn on an image surface of CAIRO_FORMAT_RGB24, which is a 32-bit word: the same bytes
/// as Bgra32 on our machines. Rgb24.
inline Frame cairo_picture(cairo_surface_t* surface) {
  cairo_surface_flush(surface);
  Frame frame;
  frame.width = cairo_image_surface_get_width(surface);
  frame.height = cairo_image_surface_get_height(surface);
  frame.stride = cairo_image_surface_get_stride(surface);
  frame.format = PixelFormat::Bgra32;
  const unsigned char* data = cairo_image_surface_get_data(surface);
  frame.bytes.assign(data, data + static_cast<std::ptrdiff_t>(frame.stride) * frame.height);
  return to_rgb24(frame);
}

}  // namespace eyebridge::camera
