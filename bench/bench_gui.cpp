// What windows cost, offscreen: the time of a frame, of a window's opening, and of the run that is
// looked at, beside the same run without a window. Figures: docs/tour.md.
#include <QApplication>
#include <QElapsedTimer>
#include <QSettings>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

#include <benchmark/benchmark.h>
#include <unistd.h>

#include "environment/environment_window.hpp"
#include "eyebridge/hal/registry.hpp"

namespace eyebridge::gui {
namespace {

struct Silence final : LogSink {
  void write(Severity, std::string_view) override {}
};

/// A field of 20 x 20 m with walls of 200 mm in rows between robots in rows.
class Field {
 public:
  Field(int robots, int walls) {
    const std::string base = "/tmp/eyebridge-bench-gui-" + std::to_string(getpid());
    std::ofstream wld(base + ".wld");
    wld << "floor 20000 20000\n0 0 20000 0\n20000 0 20000 20000\n20000 20000 0 20000\n0 20000 0 "
           "0\n";
    for (int i = 4; i < walls; ++i) {
      const int x = 300 + i % 40 * 480;
      const int y = 500 + i / 40 * 740;
      wld << x << ' ' << y << ' ' << x + 200 << ' ' << y << '\n';
    }
    wld.close();
    std::ofstream sim(base + ".sim");
    sim << "world " << base << ".wld\nrobot " << base << ".robi\n";
    for (int i = 0; i < robots; ++i) {
      sim << "Benchbot " << 1000 + i % 10 * 1900 << ' ' << 870 + i / 10 * 1480 << ' '
          << 37 * i % 360 << '\n';
    }
    sim.close();
    // Six PSDs and a LIDAR of 90 points each: more rays than robots of students have.
    std::ofstream robi(base + ".robi");
    robi << "name Benchbot\ndiameter 160\nspeed 600\nturn 300\n";
    for (int i = 1; i <= 6; ++i) {
      robi << "psd P" << i << ' ' << i << " 0 0 30 " << 60 * i - 180 << '\n';
    }
    robi << "lidar 90 0\ncamera 62 0 60 0 0\nwheel 54 3600 1100 90\ndrive DIFFERENTIAL_DRIVE\n";
    robi.close();
    const hal::Config config =
        hal::Config::load({{{"world", base + ".sim"}, {"fast", "true"}}, {}, {}});
    backend_ = hal::open_backend({config, log_});
    for (const char* ending : {".wld", ".sim", ".robi"}) std::remove((base + ending).c_str());
    const auto count = static_cast<std::size_t>(robots);
    for (std::size_t i = 0; i < count; ++i) {
      if (!environment().drive(i, {0.1, 0.5})) std::abort();  // it is there
    }
  }
  [[nodiscard]] hal::Environment& environment() { return *backend_->environment(); }
  void pass(double seconds) {
    backend_->clock().wait_until(backend_->clock().now() + from_seconds(seconds));
  }

 private:
  Silence log_;
  std::unique_ptr<hal::Backend> backend_;
};

double milliseconds(const QElapsedTimer& timer) {
  return static_cast<double>(timer.nsecsElapsed()) / 1e6;
}

double percentile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  return values.at(static_cast<std::size_t>(share * static_cast<double>(values.size() - 1)));
}

constexpr double kFrame = 1.0 / 60;

/// A frame with all layers on: a look at the world, all rays, the painting. Argument: robots.
void frame(benchmark::State& state) {
  Field field(static_cast<int>(state.range(0)), 1000);
  WorldView view(field.environment(), nullptr);
  view.resize(1280, 900);
  view.set_layers({true, true, true, true, true, true});
  view.grab();  // the ground
  std::vector<double> times;
  for ([[maybe_unused]] auto _ : state) {
    state.PauseTiming();
    field.pass(kFrame);
    state.ResumeTiming();
    QElapsedTimer timer;
    timer.start();
    view.refresh();
    benchmark::DoNotOptimize(view.grab());
    times.push_back(milliseconds(timer));
  }
  state.counters["p95_ms"] = percentile(times, 0.95);
  state.counters["look_us"] = [&] {
    hal::WorldLook look;
    QElapsedTimer timer;
    timer.start();
    for (int i = 0; i < 100; ++i) field.environment().look(look);
    return milliseconds(timer) * 10;
  }();
}
BENCHMARK(frame)->Arg(10)->Arg(100)->Unit(benchmark::kMillisecond)->MinTime(1.0);

/// Processor time of the same with one layer only, to see what each costs; 0: none, 7: all but the
/// painting. Argument: the layer, in the order of Layers.
void layer(benchmark::State& state) {
  Field field(100, 1000);
  WorldView view(field.environment(), nullptr);
  view.resize(1280, 900);
  const auto is = [&](int number) { return state.range(0) == number; };
  view.set_layers({is(1), is(2), is(3), is(4), is(5), is(6)});
  view.grab();
  for ([[maybe_unused]] auto _ : state) {
    state.PauseTiming();
    field.pass(kFrame);
    state.ResumeTiming();
    view.refresh();
    if (!is(7)) benchmark::DoNotOptimize(view.grab());
  }
}
BENCHMARK(layer)->DenseRange(0, 7)->Unit(benchmark::kMillisecond)->Iterations(150);

/// From the order for a window to its first picture.
void opening(benchmark::State& state) {
  Field field(10, 100);
  for ([[maybe_unused]] auto _ : state) {
    EnvironmentWindow window(field.environment(), "bench");
    window.show();
    benchmark::DoNotOptimize(window.grab());
  }
}
BENCHMARK(opening)->Unit(benchmark::kMillisecond);

/// Three seconds of ten robots in real time, 100 steps a second: without a window (0), and with one
/// that is painted 60 times a second (1). `busy`: share of the time that steps took, %; a step that
/// takes longer than `budget_us` makes the world late.
void real_time_run(benchmark::State& state) {
  Field field(10, 100);
  std::unique_ptr<EnvironmentWindow> window;
  if (state.range(0) != 0) {
    window = std::make_unique<EnvironmentWindow>(field.environment(), "bench");
    window->show();
  }
  constexpr int kSteps = 300;
  constexpr auto kStep = std::chrono::milliseconds(10);
  std::vector<double> steps;
  for ([[maybe_unused]] auto _ : state) {
    std::atomic<bool> has_ended = false;
    std::thread run([&] {
      auto next = std::chrono::steady_clock::now();
      for (int i = 0; i < kSteps; ++i) {
        QElapsedTimer timer;
        timer.start();
        field.pass(0.01);
        steps.push_back(1000 * milliseconds(timer));
        std::this_thread::sleep_until(next += kStep);
      }
      has_ended = true;
    });
    while (!has_ended && window) QApplication::processEvents(QEventLoop::WaitForMoreEvents, 5);
    run.join();
  }
  constexpr double kBudget = 10'000.0;
  const double sum = std::accumulate(steps.begin(), steps.end(), 0.0);
  state.counters["busy_%"] = 100 * sum / (kBudget * static_cast<double>(steps.size()));
  state.counters["step_p99_us"] = percentile(steps, 0.99);
  state.counters["step_max_us"] = percentile(steps, 1.0);
  state.counters["budget_us"] = kBudget;
}
BENCHMARK(real_time_run)
    ->Arg(0)
    ->Arg(1)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

}  // namespace
}  // namespace eyebridge::gui

int main(int argc, char** argv) {
  // No display, nobody's settings, and not a word for each window that it is so.
  qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {});
  setenv("QT_QPA_PLATFORM", "offscreen", 1);
  setenv("XDG_CONFIG_HOME", "/dev/null/none", 1);
  QElapsedTimer timer;
  timer.start();
  const QApplication application(argc, argv);
  benchmark::AddCustomContext("application_ms",
                              std::to_string(eyebridge::gui::milliseconds(timer)));
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
