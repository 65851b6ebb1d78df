#include <algorithm>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "eyebridge/base/jumping_clock.hpp"
#include "eyebridge/base/random.hpp"
#include "eyebridge/camera/birdseye.hpp"
#include "eyebridge/camera/source.hpp"
#include "process_memory.hpp"
#include "targets.hpp"

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

/// Robots in a world of `side` x `side` cells.
world::Scene robots_in(std::shared_ptr<const world::WorldModel> model, int side, int robots) {
  world::Scene scene;
  scene.model = std::move(model);
  Random random(3);
  for (int i = 0; i < robots; ++i) {
    const Pose pose{random.uniform() * side * kCell, random.uniform() * side * kCell, 0.0};
    scene.bodies.push_back({static_cast<std::uint32_t>(i),
                            world::BodyShape::Robot,
                            pose,
                            0.05,
                            0.08,
                            {200, 60, static_cast<std::uint8_t>(8 * i)}});
  }
  return scene;
}

/// What robot `number` sees of a scene that all share; its eye jumps from cell to cell.
class JumpingView final : public camera::View {
 public:
  JumpingView(const world::Scene& scene, int side, int number)
      : scene_(scene), side_(side), number_(number), step_(11 * number) {}

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
  [[nodiscard]] std::uint32_t carrier() const override {
    return static_cast<std::uint32_t>(number_);
  }
  [[nodiscard]] camera::ImageNoise noise() const override { return {}; }
  [[nodiscard]] std::string texture_directory() const override { return "."; }

 private:
  const world::Scene& scene_;
  int side_;
  int number_;
  mutable int step_;
};

constexpr Time kForever{1'000'000'000'000'000};

void render(benchmark::State& state, const char* url) {
  const auto width = static_cast<int>(state.range(0));
  const auto side = static_cast<int>(state.range(1));
  JumpingClock clock;
  const world::Scene scene = robots_in(random_maze(side), side, 10);
  JumpingView view(scene, side, 0);
  const auto source = camera::open_source(url, {&clock, &view, nullptr});
  if (!source->set_size(width, width * 3 / 4)) {
    state.SkipWithError("size refused");
    return;
  }
  for (auto _ : state) {
    const auto frame = source->next(kForever);
    if (!frame) {
      state.SkipWithError(frame.error().what.c_str());
      return;
    }
    benchmark::DoNotOptimize((*frame)->bytes.data());
  }
  if (width == 320) bench::time_at_most(state, 5e5);
  state.counters["walls"] = static_cast<double>(scene.model->walls.size());
  state.counters["frame_kB"] = 3.0 * width * width * 0.75 / 1e3;
  state.counters["process_MB"] = 1e-6 * static_cast<double>(testing::resident_bytes());
}

void sizes(benchmark::internal::Benchmark* bench) {
  bench->ArgNames({"width", "side"})->Unit(benchmark::kMillisecond);
  for (const int side : {13, 43}) {  // 200 and 2000 walls
    for (const int width : {160, 320, 640}) bench->Args({width, side});
  }
}

BENCHMARK_CAPTURE(render, osmesa, "render:osmesa")->Apply(sizes);
BENCHMARK_CAPTURE(render, egl, "render:egl")->Apply(sizes);
BENCHMARK_CAPTURE(render, fiducials, "render:osmesa?fiducials=on")
    ->ArgNames({"width", "side"})
    ->Args({640, 13})
    ->Unit(benchmark::kMillisecond);
/// A frame of each of `robots` robots, as often as 30 times a second of theirs. `x_real_time`: how
/// many times faster than their time, on one core.
void render_robots(benchmark::State& state) {
  constexpr int kSide = 43;
  const auto robots = static_cast<int>(state.range(0));
  JumpingClock clock;
  const world::Scene scene = robots_in(random_maze(kSide), kSide, robots);
  std::vector<std::unique_ptr<JumpingView>> views;
  std::vector<std::unique_ptr<camera::Source>> sources;
  for (int i = 0; i < robots; ++i) {
    views.push_back(std::make_unique<JumpingView>(scene, kSide, i));
    sources.push_back(camera::open_source("render:osmesa", {&clock, views.back().get(), nullptr}));
  }
  for (auto _ : state) {
    for (const auto& source : sources) {
      const auto frame = source->next(clock.now() + Time(40'000'000));
      if (!frame) return state.SkipWithError(frame.error().what.c_str());
      benchmark::DoNotOptimize((*frame)->bytes.data());
    }
  }
  bench::at_least(state, "x_real_time",
                  {static_cast<double>(state.iterations()) / 30.0, benchmark::Counter::kIsRate}, 1);
}
BENCHMARK(render_robots)->Arg(1)->Arg(30)->Unit(benchmark::kMillisecond);

/// From nothing to the first frame of a context, in a thread that has none yet.
void first_frame(benchmark::State& state, const char* url) {
  const world::Scene scene = robots_in(random_maze(43), 43, 10);
  JumpingClock clock;
  for (auto _ : state) {
    std::thread([&] {
      JumpingView view(scene, 43, 0);
      const auto source = camera::open_source(url, {&clock, &view, nullptr});
      benchmark::DoNotOptimize(source->next(kForever).has_value());
    }).join();
  }
}
BENCHMARK_CAPTURE(first_frame, osmesa, "render:osmesa")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

/// What each picture costs before anything is drawn: the baseline.
void render_nothing(benchmark::State& state) {
  JumpingClock clock;
  world::Scene scene;
  scene.model = std::make_shared<const world::WorldModel>();
  JumpingView view(scene, 1, 0);
  const auto source = camera::open_source("render:osmesa", {&clock, &view, nullptr});
  for (auto _ : state) benchmark::DoNotOptimize((*source->next(kForever))->bytes.data());
}
BENCHMARK(render_nothing)->Unit(benchmark::kMillisecond);

BENCHMARK_CAPTURE(render, pattern, "pattern")->Args({320, 13})->Unit(benchmark::kMillisecond);

void birdseye(benchmark::State& state) {
  world::Scene scene;
  scene.model = random_maze(16);
  for (auto _ : state) benchmark::DoNotOptimize(camera::draw_birdseye(scene, {}).bytes.data());
}
BENCHMARK(birdseye)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace eyebridge
