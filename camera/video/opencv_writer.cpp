#include <memory>
#include <stdexcept>
#include <string>

#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>

#include "eyebridge/camera/video_writer.hpp"

namespace eyebridge::camera {
namespace {

class OpencvWriter final : public VideoWriter {
 public:
  OpencvWriter(const char* path, const char* codec, Size size, double rate) : size_(size) {
    const int fourcc = cv::VideoWriter::fourcc(codec[0], codec[1], codec[2], codec[3]);
    if (!video_.open(path, cv::CAP_FFMPEG, fourcc, rate, {size.width, size.height})) {
      throw std::runtime_error("no video of " + std::to_string(size.width) + " x " +
                               std::to_string(size.height) + " pixels can be made with " + codec);
    }
  }

  void add(const Frame& picture) override {
    if (picture.format != PixelFormat::Rgb24 || Size{picture.width, picture.height} != size_) {
      throw std::runtime_error("a picture of " + std::to_string(picture.width) + " x " +
                               std::to_string(picture.height) + " pixels; expected " +
                               std::to_string(size_.width) + " x " + std::to_string(size_.height) +
                               ", R G B");
    }
    cv::Mat turned(size_.height, size_.width, CV_8UC3);
    for (int y = 0; y < size_.height; ++y) {
      const std::uint8_t* in = picture.row(y).data();
      std::uint8_t* out = turned.ptr(y);
      for (int x = 0; x < size_.width; ++x, in += 3, out += 3) {
        out[0] = in[2];
        out[1] = in[1];
        out[2] = in[0];
      }
    }
    video_.write(turned);
  }

 private:
  const Size size_;
  cv::VideoWriter video_;
};

}  // namespace
}  // namespace eyebridge::camera

extern "C" __attribute__((visibility("default"))) eyebridge::camera::VideoWriter*
eyebridge_make_video(const char* path, const char* codec, eyebridge::camera::Size size,
                     double rate) {
  try {
    return std::make_unique<eyebridge::camera::OpencvWriter>(path, codec, size, rate).release();
  } catch (const cv::Exception& error) {
    throw std::runtime_error(error.err);
  }
}
