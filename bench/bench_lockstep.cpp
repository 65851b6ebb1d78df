// A robot program in lockstep, through the C API, against the bare simulation in the same run.

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <vector>

#include <benchmark/benchmark.h>
#include <unistd.h>

#include "eyebridge/robot/simulation.hpp"
#include "eyebridge/world/world_model.hpp"
#include "process_memory.hpp"
#include "targets.hpp"
#include <eyebot.h>

namespace eyebridge {
namespace {

/// The library reads its configuration at the first call. EYEBRIDGE_FAST=false measures in real
/// time.
const bool configured = [] {
  setenv("EYEBRIDGE_FAST", "true", 0);
  setenv("EYEBRIDGE_KEYS", "KEY1@1e9s", 1);  // a script, so that no terminal is asked
  return true;
}();

void per_second(benchmark::State& state, const char* name, double amount) {
  state.counters[name] = benchmark::Counter(amount, benchmark::Counter::kIsRate);
}

/// One step of 10 ms after the other, nobody asking.
void bare_simulation(benchmark::State& state) {
  auto room = std::make_shared<world::WorldModel>();
  room->width = room->height = 2.0;
  robot::Simulation sim(std::shared_ptr<const world::WorldModel>(room), {});
  sim.add_robot({}, {1.0, 1.0, 0.0});
  sim.set_speed(0, {0.0, 0.5});
  for (auto _ : state) sim.step();
  per_second(state, "simulated_s/s", 0.010 * static_cast<double>(state.iterations()));
}
BENCHMARK(bare_simulation);

/// What a robot program does all day, 100 times a second of its clock.
void poll_and_wait(benchmark::State& state) {
  VWSetSpeed(0, 30);
  const int start = OSGetCount();
  for (auto _ : state) {
    benchmark::DoNotOptimize(PSDGet(PSD_FRONT));
    OSWait(10);
  }
  // In an int, as programs have it, a long run of milliseconds turns over: unsigned counts right.
  const unsigned passed = static_cast<unsigned>(OSGetCount()) - static_cast<unsigned>(start);
  bench::at_least(state, "simulated_s/s", {passed / 1000.0, benchmark::Counter::kIsRate}, 5000);
}
BENCHMARK(poll_and_wait);

// What programs call most.
// The clocks are the system's, and not the robot's (raw_clock.c).

void psd_get(benchmark::State& state) {
  bench::time_at_most(state, 1000);
  for (auto _ : state) benchmark::DoNotOptimize(PSDGet(PSD_FRONT));
}
BENCHMARK(psd_get);

void vw_get_position(benchmark::State& state) {
  bench::time_at_most(state, 1000);
  int x = 0;
  int y = 0;
  int phi = 0;
  for (auto _ : state) VWGetPosition(&x, &y, &phi);
  benchmark::DoNotOptimize(x + y + phi);
}
BENCHMARK(vw_get_position);

void lcd_set_printf(benchmark::State& state) {
  int i = 0;
  for (auto _ : state) LCDSetPrintf(0, 0, "PSD %5d", ++i);
}
BENCHMARK(lcd_set_printf);

/// Line after line: each scrolls the screen.
void lcd_printf(benchmark::State& state) {
  bench::time_at_most(state, 1000);
  int i = 0;
  for (auto _ : state) LCDPrintf("%d\n", ++i);
}
BENCHMARK(lcd_printf);

void lcd_image_qvga(benchmark::State& state) {
  std::vector<BYTE> image(QVGA_SIZE, 128);
  LCDImageSize(QVGA);
  for (auto _ : state) LCDImage(image.data());
}
BENCHMARK(lcd_image_qvga);

void key_read(benchmark::State& state) {
  bench::time_at_most(state, 1000);
  for (auto _ : state) benchmark::DoNotOptimize(KEYRead());
}
BENCHMARK(key_read);

/// A frame with everything around it; rss_MB is the whole process with the renderer on, target 150.
void camera_qvga(benchmark::State& state) {
  std::vector<BYTE> image(QVGA_SIZE);
  if (CAMInit(QVGA) != CAM_SUCCESS) {
    state.SkipWithError("no camera");
    return;
  }
  for (auto _ : state) CAMGet(image.data());
  bench::at_most(state, "rss_MB", 1e-6 * static_cast<double>(testing::resident_bytes()), 150);
}
BENCHMARK(camera_qvga)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace eyebridge
