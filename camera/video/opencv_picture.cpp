#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgcodecs.hpp>

#include "frames/opencv_decoder.hpp"

extern "C" __attribute__((visibility("default"))) bool eyebridge_decode_picture(
    const std::uint8_t* data, std::size_t size, int width, int height, std::uint8_t* rgb) {
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);  // we say it, once
  try {
    const std::vector<std::uint8_t> bytes(data, data + size);
    // Upright as Exif says, 8 bits a channel; what is transparent keeps the colour it has.
    const cv::Mat picture = cv::imdecode(bytes, cv::IMREAD_COLOR);
    if (picture.cols != width || picture.rows != height || picture.type() != CV_8UC3) return false;
    for (int y = 0; y < height; ++y) {
      const std::uint8_t* in = picture.ptr(y);
      for (int x = 0; x < width; ++x, in += 3, rgb += 3) {
        rgb[0] = in[2];
        rgb[1] = in[1];
        rgb[2] = in[0];
      }
    }
    return true;
  } catch (const cv::Exception&) {
    return false;
  }
}
