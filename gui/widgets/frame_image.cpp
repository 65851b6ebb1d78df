#include "widgets/frame_image.hpp"

namespace eyebridge::gui {
namespace {

QImage::Format format_of(camera::PixelFormat format) {
  switch (format) {
    case camera::PixelFormat::Rgb24:
      return QImage::Format_RGB888;
    case camera::PixelFormat::Bgra32:
      return QImage::Format_RGB32;
    case camera::PixelFormat::Grey8:
      return QImage::Format_Grayscale8;
  }
  return QImage::Format_Invalid;
}

}  // namespace

QImage image_of(const camera::Frame& frame) {
  const QImage lent(frame.bytes.data(), frame.width, frame.height, frame.stride,
                    format_of(frame.format));
  return lent.copy();
}

}  // namespace eyebridge::gui
