#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/result.hpp"
#include "eyebridge/hal/analog_inputs.hpp"
#include "timers.hpp"

namespace eyebridge::robios {

/// ANALOGRecord(): samples of one channel every millisecond, taken beside the program.
///
/// In virtual time they are taken between two calls of the program: when a call took longer, those
/// that came due meanwhile are taken one after the other. On other clocks a thread takes them;
/// where a reading takes longer than a millisecond (a board), they come as fast as they can. Any
/// thread.
class AnalogRecorder {
 public:
  /// Waits until a moment on the robot's clock.
  using WaitUntil = std::function<void(Time)>;
  static constexpr int kMostSamples = 10'000'000;

  /// Both are lent.
  AnalogRecorder(Clock& clock, Timers& timers) : clock_(clock), timers_(timers) {}
  ~AnalogRecorder();
  AnalogRecorder(const AnalogRecorder&) = delete;
  AnalogRecorder& operator=(const AnalogRecorder&) = delete;

  /// Begins to record `count` samples of `channel`; what was recorded before is forgotten. `inputs`
  /// is lent until stop(). OutOfRange for a channel or a number that cannot be.
  Result<void> start(hal::AnalogInputs& inputs, int channel, int count);
  /// Waits until all are there and hands them over: the upper 8 of the converter's 12 bits each.
  /// Nothing when nothing was recorded since. Fails as a reading that failed.
  Result<std::vector<std::uint8_t>> take(const WaitUntil& wait_until);
  /// Ends a recording that is under way.
  void stop();

 private:
  struct Task {
    hal::AnalogInputs* inputs = nullptr;
    int channel = 0;
    int count = 0;
    Time start{0};
  };

  void sample_due();
  void run(Task task);
  /// One sample; false when the recording has ended.
  bool sample(const Task& task);
  [[nodiscard]] bool is_done() const;  // under mutex_

  Clock& clock_;
  Timers& timers_;
  std::mutex switching_;  // taken before mutex_
  std::mutex mutex_;
  std::optional<Task> task_;
  std::vector<std::uint8_t> samples_;
  std::optional<Error> failure_;
  int timer_ = 0;
  std::thread thread_;
};

}  // namespace eyebridge::robios
