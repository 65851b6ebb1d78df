// MJPEG as webcams send it, from one device to us and to OpenCV's VideoCapture: who gets more?
// Needs the v4l2loopback device that EYEBRIDGE_TEST_VIDEO names: the lab runs it.
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <thread>

#include <gtest/gtest.h>
#include <opencv2/videoio.hpp>

#include "eyebridge/bridges/monotonic_clock.hpp"
#include "eyebridge/camera/source.hpp"
#include "jpeg_pictures.hpp"
#include "loopback_writer.hpp"
#include "patience.hpp"
#include "reference_colours.hpp"

namespace eyebridge::camera::testing {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr int kMjpegWidth = 320;
constexpr int kMjpegHeight = 240;
constexpr int kShown = 10;

std::string camera_device() {
  const char* name = std::getenv("EYEBRIDGE_TEST_VIDEO");
  return name == nullptr ? "/dev/video0" : name;
}

Bytes with(Bytes jpeg, std::ptrdiff_t at, const Bytes& more) {
  jpeg.insert(at >= 0 ? jpeg.begin() + at : jpeg.end() + at + 1, more.begin(), more.end());
  return jpeg;
}

/// How a camera's JPEGs differ from those of the standard.
struct OddStream {
  const char* name;
  Bytes (*make)(const Bytes& jpeg);
};
void PrintTo(const OddStream& one, std::ostream* out) { *out << one.name; }

const OddStream kOddStreams[] = {
    {"Usual", [](const Bytes& jpeg) { return jpeg; }},
    {"NoEnd", [](const Bytes& jpeg) { return Bytes(jpeg.begin(), jpeg.end() - 2); }},
    {"NoTables", [](const Bytes& jpeg) { return without_tables(jpeg); }},
    {"BytesAfterItsEnd",
     [](const Bytes& jpeg) {
       return with(jpeg, -1, {1, 2, 3, 4, 5});
     }},
    {"FilledUpWithZeros", [](const Bytes& jpeg) { return with(jpeg, -1, Bytes(2000)); }},
    {"BytesBetweenItsParts",
     [](const Bytes& jpeg) {
       return with(jpeg, 2, {0x00, 0x12, 0x34});
     }},
    {"BytesBeforeIt",
     [](const Bytes& jpeg) {
       return with(jpeg, 0, {0x00, 0x12});
     }},
};

/// Sends one picture again and again, as a camera does, until it is gone.
class Sender {
 public:
  explicit Sender(Bytes frame) : frame_(std::move(frame)) {}
  ~Sender() {
    is_over_ = true;
    thread_.join();
  }

 private:
  void run() {
    bridges::MonotonicClock clock;
    while (!is_over_) {
      writer_.write(frame_);
      clock.wait_until(clock.now() + std::chrono::milliseconds(33));  // the rhythm of a camera
    }
  }

  Bytes frame_;
  LoopbackWriter writer_{camera_device(), V4L2_PIX_FMT_MJPEG, kMjpegWidth, kMjpegHeight};
  std::atomic<bool> is_over_{false};
  std::thread thread_{[this] { run(); }};
};

class MjpegLoopback : public ::testing::TestWithParam<OddStream> {};

TEST_P(MjpegLoopback, WeGetTheFramesThatVideoCaptureGets) {
  const Bytes picture = smooth_picture(kMjpegWidth, kMjpegHeight, 3);
  const Sender sender(GetParam().make(jpeg_of(picture, kMjpegWidth, kMjpegHeight)));
  int theirs = 0;
  {
    cv::VideoCapture capture(camera_device(), cv::CAP_V4L2);
    ASSERT_TRUE(capture.isOpened());
    capture.set(cv::CAP_PROP_FOURCC, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'));
    for (int i = 0; i < kShown; ++i) {
      cv::Mat frame;
      if (!capture.read(frame) || frame.empty()) continue;
      Bytes rgb;
      for (int y = 0; y < frame.rows; ++y) {
        for (int x = 0; x < frame.cols; ++x) {
          const auto& bgr = frame.at<cv::Vec3b>(y, x);
          rgb.insert(rgb.end(), {bgr[2], bgr[1], bgr[0]});
        }
      }
      theirs += rgb.size() == picture.size() && psnr(rgb, picture) >= 40.0 ? 1 : 0;
    }
  }
  bridges::MonotonicClock clock;
  const auto source =
      open_source("v4l2:" + camera_device() + "?size=320x240", {&clock, nullptr, nullptr});
  int ours = 0;
  for (int i = 0; i < kShown; ++i) {
    const Result<FramePtr> frame = source->next(clock.now() + kPatience);
    ours += frame && psnr((*frame)->bytes, picture) >= 40.0 ? 1 : 0;
  }
  RecordProperty("theirs", theirs);
  EXPECT_EQ(ours, kShown) << "VideoCapture got " << theirs;
  if (GetParam().name == std::string("Usual")) {
    EXPECT_EQ(theirs, kShown) << "the test would compare with nothing";
  }
}

INSTANTIATE_TEST_SUITE_P(Streams, MjpegLoopback, ::testing::ValuesIn(kOddStreams),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace eyebridge::camera::testing
