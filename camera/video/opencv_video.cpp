#include <cmath>
#include <cstdarg>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>

#include <dlfcn.h>
#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <opencv2/videoio/registry.hpp>

#include "frames/video_reader.hpp"

namespace eyebridge::camera {
namespace {

class OpencvVideo final : public VideoReader {
 public:
  explicit OpencvVideo(const char* path) : path_(path) {
    rewind();
    size_ = {static_cast<int>(std::lround(video_.get(cv::CAP_PROP_FRAME_WIDTH) * pixel_aspect())),
             static_cast<int>(video_.get(cv::CAP_PROP_FRAME_HEIGHT))};
    const double rate = video_.get(cv::CAP_PROP_FPS);
    rate_ = std::isfinite(rate) && rate > 0.0 ? rate : 0.0;
  }

  [[nodiscard]] Size size() const override { return size_; }
  [[nodiscard]] double rate() const override { return rate_; }

  std::optional<Time> grab() override {
    try {
      if (!video_.grab()) return std::nullopt;
      return from_seconds(video_.get(cv::CAP_PROP_POS_MSEC) / 1000.0);
    } catch (const cv::Exception&) {
      return std::nullopt;
    }
  }

  Frame retrieve() override {
    cv::Mat picture;
    if (!video_.retrieve(picture) || picture.empty()) {
      throw std::runtime_error("it cannot be decoded");
    }
    if (picture.type() != CV_8UC3) throw std::runtime_error("its pixels are not of 24 bits");
    if (picture.cols != size_.width) {  // pixels that are not square
      cv::resize(picture, picture, {size_.width, picture.rows}, 0, 0, cv::INTER_LINEAR);
    }
    Frame frame;
    frame.width = picture.cols;
    frame.height = picture.rows;
    frame.stride = 3 * picture.cols;
    frame.bytes.resize(static_cast<std::size_t>(frame.stride) *
                       static_cast<std::size_t>(frame.height));
    std::uint8_t* out = frame.bytes.data();
    for (int y = 0; y < picture.rows; ++y) {
      const std::uint8_t* in = picture.ptr(y);
      for (int x = 0; x < picture.cols; ++x, in += 3, out += 3) {
        out[0] = in[2];
        out[1] = in[1];
        out[2] = in[0];
      }
    }
    return frame;
  }

  // Opened again: not every container can be sought in.
  void rewind() override {
    try {
      if (!video_.open(path_, cv::CAP_FFMPEG))
        throw std::runtime_error("no video that can be read");
    } catch (const cv::Exception& error) {
      throw std::runtime_error(error.err);
    }
  }

 private:
  /// Width of a pixel by its height; 1 where the file does not say it, or nonsense.
  [[nodiscard]] double pixel_aspect() const {
    const double width = video_.get(cv::CAP_PROP_SAR_NUM);
    const double height = video_.get(cv::CAP_PROP_SAR_DEN);
    const double aspect = width / height;
    return aspect >= 0.1 && aspect <= 10.0 ? aspect : 1.0;
  }

  std::string path_;
  cv::VideoCapture video_;
  Size size_;
  double rate_ = 0.0;
};

/// What goes wrong is said once, by us; OPENCV_FFMPEG_DEBUG brings the libraries' own words back.
void silence_libraries() {
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  if (std::getenv("OPENCV_FFMPEG_DEBUG") != nullptr) return;
  // Not its level, which OpenCV sets at each opening. FFmpeg's headers are not asked for.
  using Callback = void (*)(void*, int, const char*, va_list);
  if (void* set_callback = dlsym(RTLD_DEFAULT, "av_log_set_callback")) {
    reinterpret_cast<void (*)(Callback)>(set_callback)([](void*, int, const char*, va_list) {});
  }
}

}  // namespace
}  // namespace eyebridge::camera

extern "C" __attribute__((visibility("default"))) eyebridge::camera::VideoReader*
eyebridge_open_video(const char* path) {
  if (!cv::videoio_registry::hasBackend(cv::CAP_FFMPEG)) {
    throw std::runtime_error("this OpenCV was built without FFmpeg, which reads videos");
  }
  static const bool silent = (eyebridge::camera::silence_libraries(), true);
  static_cast<void>(silent);
  return std::make_unique<eyebridge::camera::OpencvVideo>(path).release();
}
