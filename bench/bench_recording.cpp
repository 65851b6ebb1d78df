// What recording a frame costs, a rendered-like one without noise and a webcam's with it: our
// lossless codec against zlib alone and a PNG, MJPEG, and the whole way into the file.
#include <algorithm>
#include <filesystem>

#include <benchmark/benchmark.h>
#include <unistd.h>
#include <zlib.h>

#include "eyebridge/base/random.hpp"
#include "eyebridge/camera/convert.hpp"
#include "eyebridge/camera/png.hpp"
#include "eyebridge/camera/recording/frame_table.hpp"

namespace {

using namespace eyebridge;
using camera::Frame;
using camera::FrameCodec;

/// Wall, floor and boxes; state.range(0) is the width, range(1) the sigma of the noise.
Frame scene(const benchmark::State& state) {
  const int width = static_cast<int>(state.range(0));
  Frame frame = camera::make_frame(width, width * 3 / 4, camera::PixelFormat::Rgb24);
  Random random(1);
  auto out = frame.bytes.begin();
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool floor = y > frame.height / 2;
      const bool box = (x * 8 / width + y * 8 / frame.height) % 2 == 0;
      for (int c = 0; c < 3; ++c) {
        const double base =
            floor ? 60.0 + 20 * c + 0.1 * y : (box ? 90.0 : 170.0) + 60.0 * x / width;
        const double value = base + static_cast<double>(state.range(1)) * random.gaussian();
        *out++ = static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0));
      }
    }
  }
  return frame;
}

void sizes(benchmark::internal::Benchmark* bench) {
  bench->ArgNames({"width", "sigma"});
  for (const int width : {320, 640}) {
    for (const int sigma : {0, 3}) bench->Args({width, sigma});
  }
  bench->Unit(benchmark::kMillisecond);
}

void encode(benchmark::State& state, FrameCodec codec) {
  const Frame frame = scene(state);
  std::size_t bytes = 0;
  for (auto _ : state) bytes = camera::encode_frame(frame, codec).size();
  state.counters["bytes"] = static_cast<double>(bytes);
}
void lossless(benchmark::State& state) { encode(state, FrameCodec::Lossless); }
void mjpeg(benchmark::State& state) { encode(state, FrameCodec::Mjpeg); }

/// Baseline: zlib's fastest level on the pixels as they are.
void zlib_alone(benchmark::State& state) {
  const Frame frame = scene(state);
  std::vector<std::uint8_t> out(compressBound(frame.bytes.size()));
  uLongf bytes = 0;
  for (auto _ : state) {
    bytes = out.size();
    benchmark::DoNotOptimize(
        compress2(out.data(), &bytes, frame.bytes.data(), frame.bytes.size(), 1));
  }
  state.counters["bytes"] = static_cast<double>(bytes);
}

std::filesystem::path scratch(const char* end) {
  return std::filesystem::temp_directory_path() /
         ("eyebridge-bench-" + std::to_string(getpid()) + end);
}

/// Baseline: what --out does with a frame.
void png_file(benchmark::State& state) {
  const Frame frame = scene(state);
  const auto path = scratch(".png");
  for (auto _ : state) camera::write_png(frame, path);
  state.counters["bytes"] = static_cast<double>(std::filesystem::file_size(path));
  std::filesystem::remove(path);
}

/// The whole way: packed, written, committed each second of the robot's clock.
void into_recording(benchmark::State& state) {
  const Frame frame = scene(state);
  const auto path = scratch(".ebrec");
  {
    camera::RecordingFile file(path, {});
    camera::FrameWriter writer(file, FrameCodec::Lossless);
    Time now{0};
    for (auto _ : state) writer.add(frame, now += std::chrono::milliseconds(33));
  }
  std::filesystem::remove(path);
}

void decode(benchmark::State& state) {
  const Frame frame = scene(state);
  const auto data = camera::encode_frame(frame, FrameCodec::Lossless);
  for (auto _ : state) {
    benchmark::DoNotOptimize(camera::decode_frame(
        data, FrameCodec::Lossless, {frame.width, frame.height}, camera::PixelFormat::Rgb24));
  }
}

BENCHMARK(lossless)->Apply(sizes);
BENCHMARK(zlib_alone)->Apply(sizes);
BENCHMARK(png_file)->Apply(sizes);
BENCHMARK(mjpeg)->Apply(sizes);
BENCHMARK(into_recording)->Apply(sizes);
BENCHMARK(decode)->Apply(sizes);

}  // namespace
