// How long a program waits for a distance from a board over a pseudo-terminal: one in the
// firmware's own process, and one on the emulated Cortex-M3.
#include <algorithm>
#include <chrono>
#include <memory>
#include <vector>

#include <benchmark/benchmark.h>

#include "../tests/support/running_firmware.hpp"
#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/log.hpp"
#include "eyebridge/hal/registry.hpp"

namespace eyebridge {
namespace {

class Silent final : public LogSink {
 public:
  void write(Severity /*severity*/, std::string_view /*message*/) override {}
};

void psd_read(benchmark::State& state, const std::vector<std::string>& more) {
  const testing::ScratchFolder folder;
  std::vector<std::string> arguments{"--world", EYEBRIDGE_SOURCE_DIR "/worlds/maze-5.maz", "--pty",
                                     "./eyebot.tty"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  testing::RunningFirmware firmware(arguments, folder.path());
  if (firmware.wait_for("Ctrl-C ends\n").find("Ctrl-C ends\n") == std::string::npos) {
    state.SkipWithError("the firmware did not start");
    return;
  }
  Silent log;
  std::unique_ptr<hal::Backend> backend;
  try {
    const auto config =
        hal::Config::load({{{"hal", "serial:" + folder.path() + "/eyebot.tty"}}, {}, {}});
    backend = hal::open_backend({config, log});
  } catch (const ConfigError& error) {
    state.SkipWithError(error.what());
    return;
  }
  hal::RangeSensor* psd = backend->range_sensor(1);
  std::vector<double> seconds;
  double unanswered = 0;  // on a machine that is too busy
  for ([[maybe_unused]] auto _ : state) {
    const auto begin = std::chrono::steady_clock::now();
    if (!psd->read_raw()) ++unanswered;
    seconds.push_back(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  std::ranges::sort(seconds);
  state.counters["median_us"] = seconds[seconds.size() / 2] * 1e6;
  state.counters["p99_us"] = seconds[seconds.size() * 99 / 100] * 1e6;
  state.counters["max_us"] = seconds.back() * 1e6;
  state.counters["unanswered"] = unanswered;
}

BENCHMARK_CAPTURE(psd_read, Pty, {})->UseRealTime();
BENCHMARK_CAPTURE(psd_read, CortexM3, {"--cortex-m3"})->UseRealTime();

}  // namespace
}  // namespace eyebridge
