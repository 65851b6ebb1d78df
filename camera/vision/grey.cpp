#include "vision/grey.hpp"

#include <opencv2/imgproc.hpp>

namespace eyebridge::camera {

cv::Mat grey_of(const Frame& frame) {
  // OpenCV has no matrix of constant bytes.
  void* bytes = const_cast<std::uint8_t*>(frame.bytes.data());
  const auto stride = static_cast<std::size_t>(frame.stride);
  cv::Mat pixels(frame.height, frame.width, CV_8UC(bytes_per_pixel(frame.format)), bytes, stride);
  if (frame.format == PixelFormat::Grey8) return pixels;
  cv::Mat grey;
  cv::cvtColor(pixels, grey,
               frame.format == PixelFormat::Rgb24 ? cv::COLOR_RGB2GRAY : cv::COLOR_BGRA2GRAY);
  return grey;
}

}  // namespace eyebridge::camera
