#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <benchmark/benchmark.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <turbojpeg.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/random.hpp"
#include "eyebridge/bridges/monotonic_clock.hpp"
#include "eyebridge/camera/convert.hpp"
#include "eyebridge/camera/source.hpp"
#include "pixels/pixel_decoder.hpp"
#include "tests/camera/v4l2/jpeg_pictures.hpp"
#include "tests/camera/v4l2/loopback_writer.hpp"

// CPU milliseconds from a camera's bytes to the frame that a program gets, and OpenCV's beside it.
// Conversion alone runs anywhere; "live" needs the camera that EYEBRIDGE_BENCH_CAMERA names, and is
// fed with our own frames when that is a v4l2loopback device (tests/lab/run --module ...).

namespace eyebridge {
namespace {

using Bytes = std::vector<std::uint8_t>;
using camera::RawFormat;
using camera::Size;

constexpr int kQuality = 80;  // as webcams have it: 36 kB for a VGA frame of a room

/// A picture with as much in it as a room has: smooth surfaces, edges, a little noise.
Bytes room(Size size) {
  Random random(5);
  Bytes rgb = camera::testing::smooth_picture(size.width, size.height);
  for (int i = 0; i < 60; ++i) {
    const int left = static_cast<int>(random.uniform() * size.width);
    const int top = static_cast<int>(random.uniform() * size.height);
    const auto light = static_cast<std::uint8_t>(random.uniform() * 255.0);
    for (int y = top; y < std::min(size.height, top + size.height / 5); ++y) {
      for (int x = left; x < std::min(size.width, left + size.width / 8); ++x) {
        rgb[static_cast<std::size_t>(3 * (y * size.width + x) + i % 3)] = light;
      }
    }
  }
  for (std::uint8_t& byte : rgb)
    byte = static_cast<std::uint8_t>(byte / 2 + 64 + random.uniform() * 6.0);
  return rgb;
}

Bytes raw_of(RawFormat format, Size size) {
  if (format == RawFormat::Mjpeg) {
    return camera::testing::jpeg_of(room(size), size.width, size.height, kQuality);
  }
  Random random(3);
  Bytes out(static_cast<std::size_t>(size.width * size.height * 2));
  for (std::uint8_t& byte : out) byte = static_cast<std::uint8_t>(random.uniform() * 256.0);
  return out;
}

std::uint32_t fourcc_of(RawFormat format) {
  return format == RawFormat::Mjpeg ? V4L2_PIX_FMT_MJPEG : V4L2_PIX_FMT_YUYV;
}

Size size_of(const benchmark::State& state) {
  return {static_cast<int>(state.range(0)), static_cast<int>(state.range(0)) * 3 / 4};
}

void convert_ours(benchmark::State& state, RawFormat format, int divisor) {
  const Size size = size_of(state);
  const Bytes raw = raw_of(format, size);
  camera::PixelDecoder decoder;
  for (auto _ : state) {
    const camera::FramePtr frame = decoder.share(
        *decoder.decode({format, size, 0, raw}, {size.width / divisor, size.height / divisor}));
    benchmark::DoNotOptimize(frame->bytes.data());
  }
  state.counters["raw_kB"] = static_cast<double>(raw.size()) / 1e3;
}

void convert_opencv(benchmark::State& state, RawFormat format, int divisor) {
  cv::setNumThreads(1);
  const Size size = size_of(state);
  Bytes raw = raw_of(format, size);
  for (auto _ : state) {
    cv::Mat out;
    if (format == RawFormat::Mjpeg) {
      out = cv::imdecode(raw, cv::IMREAD_COLOR);
    } else {
      cv::cvtColor(cv::Mat(size.height, size.width, CV_8UC2, raw.data()), out,
                   cv::COLOR_YUV2RGB_YUY2);
    }
    if (divisor > 1) {
      cv::Mat small;
      cv::resize(out, small, {size.width / divisor, size.height / divisor}, 0, 0, cv::INTER_AREA);
      out = small;
    }
    benchmark::DoNotOptimize(out.data);
  }
}

/// The least that any use of libjpeg-turbo takes: no new memory, no frame, no check of the header.
void convert_turbojpeg(benchmark::State& state, RawFormat format) {
  const Size size = size_of(state);
  const Bytes raw = raw_of(format, size);
  Bytes rgb(static_cast<std::size_t>(3 * size.width * size.height));
  const std::unique_ptr<void, int (*)(void*)> decoder(tjInitDecompress(), tjDestroy);
  for (auto _ : state) {
    const int failed = tjDecompress2(decoder.get(), raw.data(), raw.size(), rgb.data(), size.width,
                                     0, size.height, TJPF_RGB, TJFLAG_FASTUPSAMPLE);
    if (failed != 0) state.SkipWithError(tjGetErrorStr2(decoder.get()));
    benchmark::DoNotOptimize(rgb.data());
  }
}

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) / 1e9;
}

const char* bench_camera() { return std::getenv("EYEBRIDGE_BENCH_CAMERA"); }

/// Takes the first frame: OpenCV starts to stream only then, and loses what was written before.
template <class Take>
void begin(Take& take, std::optional<camera::testing::LoopbackWriter>& writer, const Bytes& raw) {
  std::atomic<bool> begun = false;
  std::thread feeder([&] {
    while (writer && !begun) {
      writer->write(raw);
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  });
  take();
  begun = true;
  feeder.join();
}

/// Feeds the camera if it can be fed, and measures the thread's CPU time in `take`, which opens on
/// the first call and is true for a frame.
template <class Open>
void live(benchmark::State& state, RawFormat format, Open open) {
  const Size size = size_of(state);
  const Bytes raw = raw_of(format, size);
  std::optional<camera::testing::LoopbackWriter> writer;
  try {
    writer.emplace(bench_camera(), fourcc_of(format), size.width, size.height);
  } catch (const std::runtime_error&) {  // it is a camera of its own
  }
  try {
    auto take = open(size);
    begin(take, writer, raw);
    for (auto _ : state) {
      if (writer) writer->write(raw);
      const double start = thread_seconds();
      const bool good = take();
      state.SetIterationTime(thread_seconds() - start);
      if (!good) {
        state.SkipWithError("no frame");
        break;
      }
    }
  } catch (const std::runtime_error& error) {
    state.SkipWithError(error.what());
  }
}

void live_ours(benchmark::State& state, RawFormat format) {
  bridges::MonotonicClock clock;
  live(state, format, [&](Size size) {
    const std::string url = "v4l2:" + std::string(bench_camera()) +
                            "?size=" + std::to_string(size.width) + "x" +
                            std::to_string(size.height) +
                            (format == RawFormat::Mjpeg ? "&format=MJPEG" : "&format=YUYV");
    const std::shared_ptr<camera::Source> source =
        camera::open_source(url, {&clock, nullptr, nullptr});
    // OpenCV's patience is no reading of a clock for each frame either.
    const Time deadline = clock.now() + std::chrono::minutes(1);
    return [deadline, source] {
      const auto frame = source->next(deadline);
      if (frame) benchmark::DoNotOptimize((*frame)->bytes.data());
      return frame.has_value();
    };
  });
}

void live_opencv(benchmark::State& state, RawFormat format) {
  cv::setNumThreads(1);
  live(state, format, [&](Size size) {
    const auto capture = std::make_shared<cv::VideoCapture>(bench_camera(), cv::CAP_V4L2);
    capture->set(cv::CAP_PROP_FOURCC, fourcc_of(format));
    capture->set(cv::CAP_PROP_FRAME_WIDTH, size.width);
    capture->set(cv::CAP_PROP_FRAME_HEIGHT, size.height);
    return [capture, picture = cv::Mat()]() mutable {
      const bool good = capture->read(picture);
      benchmark::DoNotOptimize(picture.data);
      return good;
    };
  });
}

void sizes(benchmark::internal::Benchmark* bench) {
  bench->ArgName("width")->Arg(320)->Arg(640)->Unit(benchmark::kMillisecond);
}
void frames(benchmark::internal::Benchmark* bench) {
  sizes(bench);
  bench->UseManualTime()->Iterations(500);
}

BENCHMARK_CAPTURE(convert_ours, yuyv, RawFormat::Yuyv, 1)->Apply(sizes);
BENCHMARK_CAPTURE(convert_opencv, yuyv, RawFormat::Yuyv, 1)->Apply(sizes);
BENCHMARK_CAPTURE(convert_ours, yuyv_to_half, RawFormat::Yuyv, 2)->Apply(sizes);
BENCHMARK_CAPTURE(convert_opencv, yuyv_to_half, RawFormat::Yuyv, 2)->Apply(sizes);
BENCHMARK_CAPTURE(convert_ours, mjpeg, RawFormat::Mjpeg, 1)->Apply(sizes);
BENCHMARK_CAPTURE(convert_opencv, mjpeg, RawFormat::Mjpeg, 1)->Apply(sizes);
BENCHMARK_CAPTURE(convert_turbojpeg, mjpeg, RawFormat::Mjpeg)->Apply(sizes);
BENCHMARK_CAPTURE(convert_ours, mjpeg_to_half, RawFormat::Mjpeg, 2)->Apply(sizes);
BENCHMARK_CAPTURE(convert_opencv, mjpeg_to_half, RawFormat::Mjpeg, 2)->Apply(sizes);
const bool kLive = [] {
  if (bench_camera() == nullptr) return false;
  using benchmark::RegisterBenchmark;
  frames(RegisterBenchmark("live_ours/yuyv", live_ours, RawFormat::Yuyv));
  frames(RegisterBenchmark("live_opencv/yuyv", live_opencv, RawFormat::Yuyv));
  frames(RegisterBenchmark("live_ours/mjpeg", live_ours, RawFormat::Mjpeg));
  frames(RegisterBenchmark("live_opencv/mjpeg", live_opencv, RawFormat::Mjpeg));
  return true;
}();

}  // namespace
}  // namespace eyebridge
