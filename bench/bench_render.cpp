#include <algorithm>
#include <fstream>
#include <memory>
#include <string>

#include <benchmark/benchmark.h>

#include "eyebridge/base/random.hpp"
#include "eyebridge/camera/birdseye.hpp"
#include "eyebridge/camera/source.hpp"

// CPU milliseconds a rendered frame; the camera stands elsewhere in the maze for every frame.

namespace eyebridge {
namespace {

constexpr double kCell = 0.3;

/// A maze of `side` x `side` cells with half of its inner walls, at random.
std::shared_ptr<const world::WorldModel> random_maze(int side) {
  world::MazeGrid maze;
  maze.columns = maze.rows = side;
  maze.cell = kCell;
  Random random(7);
  const auto edge = [&](bool boundary) {
    return boundary || random.chance(0.5) ? char{1} : char{0};
  };
  for (int i = 0; i < side * (side + 1); ++i) {
    maze.south.push_back(edge(i < side || i >= side * side));
  }
  for (int i = 0; i < side * (side + 1); ++i) {
    maze.west.push_back(edge(i % (side + 1) == 0 || i % (side + 1) == side));
  }
  auto model = std::make_shared<world::WorldModel>();
  model->width = model->height = side * kCell;
  model->walls = world::walls_of(maze);
  return model;
}

class StillClock final : public Clock {
 public:
  [[nodiscard]] Time now() const override { return now_; }
  void wait_until(Time deadline) override { now_ = std::max(now_, deadline); }
  void spend(Time cost) override { now_ += cost; }
  [[nodiscard]] bool is_virtual() const override { return true; }

 private:
  Time now_{0};
};

/// Ten robots in a maze; the eye jumps from cell to cell.
class MazeView final : public camera::View {
 public:
  explicit MazeView(int side) : side_(side) {
    scene_.model = random_maze(side);
    Random random(3);
    for (std::uint32_t i = 0; i < 10; ++i) {
      const Pose pose{random.uniform() * side * kCell, random.uniform() * side * kCell, 0.0};
      scene_.bodies.push_back({i,
                               world::BodyShape::Robot,
                               pose,
                               0.05,
                               0.08,
                               {200, 60, static_cast<std::uint8_t>(20 * i)}});
    }
  }
  [[nodiscard]] world::Scene scene() const override { return scene_; }
  [[nodiscard]] camera::Eye eye() const override {
    const int cell = step_++;
    camera::Eye eye;
    eye.x = kCell * (0.5 + cell % side_);
    eye.y = kCell * (0.5 + cell * 7 / 3 % side_);
    eye.z = 0.12;
    eye.heading = 0.1 * cell;
    return eye;
  }
  [[nodiscard]] std::uint32_t carrier() const override { return 0; }
  [[nodiscard]] camera::ImageNoise noise() const override { return {}; }
  [[nodiscard]] std::string texture_directory() const override { return "."; }

 private:
  int side_;
  world::Scene scene_;
  mutable int step_ = 0;
};

/// Memory of this process that is in RAM, MB (Linux, statm: second field, pages of 4 KiB).
double resident_megabytes() {
  long total = 0;
  long resident = 0;
  std::ifstream("/proc/self/statm") >> total >> resident;
  return static_cast<double>(resident) * 4096.0 / 1e6;
}

void render(benchmark::State& state, const char* url) {
  const auto width = static_cast<int>(state.range(0));
  StillClock clock;
  MazeView view(static_cast<int>(state.range(1)));
  const auto source = camera::open_source(url, {&clock, &view, nullptr});
  if (!source->set_size(width, width * 3 / 4)) {
    state.SkipWithError("size refused");
    return;
  }
  const Time forever{1'000'000'000'000'000};
  for (auto _ : state) {
    const auto frame = source->next(forever);
    if (!frame) {
      state.SkipWithError(frame.error().what.c_str());
      return;
    }
    benchmark::DoNotOptimize((*frame)->bytes.data());
  }
  state.counters["walls"] = static_cast<double>(view.scene().model->walls.size());
  state.counters["frame_kB"] = 3.0 * width * width * 0.75 / 1e3;
  state.counters["process_MB"] = resident_megabytes();
}

void sizes(benchmark::internal::Benchmark* bench) {
  bench->ArgNames({"width", "side"})->Unit(benchmark::kMillisecond);
  for (const int side : {13, 43}) {  // 200 and 2000 walls
    for (const int width : {160, 320, 640}) bench->Args({width, side});
  }
}

BENCHMARK_CAPTURE(render, osmesa, "render:osmesa")->Apply(sizes);
BENCHMARK_CAPTURE(render, egl, "render:egl")->Apply(sizes);
BENCHMARK_CAPTURE(render, pattern, "pattern")->Args({320, 13})->Unit(benchmark::kMillisecond);

void birdseye(benchmark::State& state) {
  world::Scene scene;
  scene.model = random_maze(16);
  for (auto _ : state) benchmark::DoNotOptimize(camera::draw_birdseye(scene, {}).bytes.data());
}
BENCHMARK(birdseye)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace eyebridge
