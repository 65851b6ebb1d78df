// A call to a device with and without a note for a window.
#include <memory>
#include <string_view>
#include <vector>

#include <benchmark/benchmark.h>

#include "eyebridge/hal/device_notes.hpp"
#include "eyebridge/hal/passing_backend.hpp"

namespace eyebridge::hal {
namespace {

class TestClock final : public Clock {
 public:
  explicit TestClock(bool is_virtual) : is_virtual_(is_virtual) {}
  [[nodiscard]] Time now() const override { return Time(1); }
  void wait_until(Time) override {}
  void spend(Time) override {}
  [[nodiscard]] bool is_virtual() const override { return is_virtual_; }

 private:
  bool is_virtual_;
};

class OneSensor final : public RangeSensor {
 public:
  Result<double> read() override { return value_ += 0.001; }
  Result<int> read_raw() override { return 1; }
  [[nodiscard]] double out_of_range() const override { return 10.0; }

 private:
  double value_ = 0.0;
};

/// A robot that has one sensor and nothing else.
class OneSensorRobot final : public Backend {
 public:
  explicit OneSensorRobot(bool is_virtual) : clock_(is_virtual) {}
  Clock& clock() override { return clock_; }
  [[nodiscard]] int robot_id() const override { return 1; }
  Device* find(DeviceKind kind, int id) override {
    return kind == DeviceKind::Psd && id == 1 ? &sensor_ : nullptr;
  }
  WorldControl* world() override { return nullptr; }
  camera::View* camera_view() override { return nullptr; }
  camera::Source* camera_source() override { return nullptr; }
  std::vector<DeviceFacts> facts_of(std::string_view) override { return {}; }
  void trace_to(TraceSink*) override {}
  Result<void> stop() noexcept override { return {}; }

 private:
  TestClock clock_;
  OneSensor sensor_;
};

void read_again_and_again(benchmark::State& state, Backend& robot) {
  for (auto _ : state) benchmark::DoNotOptimize(robot.range_sensor(1)->read());
}

void bare(benchmark::State& state) {
  const std::unique_ptr<Backend> robot = std::make_unique<OneSensorRobot>(false);
  read_again_and_again(state, *robot);
}
BENCHMARK(bare);

void passed_on(benchmark::State& state) {
  PassingBackend robot(std::make_unique<OneSensorRobot>(false));
  read_again_and_again(state, robot);
}
BENCHMARK(passed_on);

void noted_in_virtual_time(benchmark::State& state) {
  const NotedBackend noted = with_notes(std::make_unique<OneSensorRobot>(true));
  read_again_and_again(state, *noted.backend);
}
BENCHMARK(noted_in_virtual_time);

void noted_in_real_time(benchmark::State& state) {
  const NotedBackend noted = with_notes(std::make_unique<OneSensorRobot>(false));
  read_again_and_again(state, *noted.backend);
}
BENCHMARK(noted_in_real_time);

}  // namespace
}  // namespace eyebridge::hal
