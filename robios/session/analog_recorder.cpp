#include "analog_recorder.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include <pthread.h>

namespace eyebridge::robios {
namespace {

constexpr Time kSamplePeriod = std::chrono::milliseconds(1);
constexpr unsigned kDroppedBits = 4;  // of 12: a sample is one byte

}  // namespace

AnalogRecorder::~AnalogRecorder() { stop(); }

bool AnalogRecorder::is_done() const {
  return !task_ || failure_ || samples_.size() >= static_cast<std::size_t>(task_->count);
}

Result<void> AnalogRecorder::start(hal::AnalogInputs& inputs, int channel, int count) {
  if (count < 1 || count > kMostSamples) {
    return fail(Errc::OutOfRange, std::to_string(count) + " samples, expected 1 … 10000000");
  }
  // A channel that cannot be read is a mistake now, not when the samples are asked for.
  if (const auto first = inputs.read(channel); !first) return tl::unexpected(first.error());
  stop();
  const std::lock_guard switching(switching_);
  const Task task{&inputs, channel, count, clock_.now()};
  {
    const std::lock_guard lock(mutex_);
    samples_.clear();
    failure_.reset();
    task_ = task;
  }
  if (clock_.is_virtual()) {
    timer_ = timers_.attach(kSamplePeriod, [this] { sample_due(); });
  } else {
    thread_ = std::thread([this, task] { run(task); });
  }
  return {};
}

void AnalogRecorder::stop() {
  const std::lock_guard switching(switching_);
  {
    const std::lock_guard lock(mutex_);
    task_.reset();
  }
  if (timer_ != 0) timers_.detach(std::exchange(timer_, 0));
  if (thread_.joinable()) thread_.join();
}

bool AnalogRecorder::sample(const Task& task) {
  const Result<int> value = task.inputs->read(task.channel);
  const std::lock_guard lock(mutex_);
  if (is_done()) return false;
  if (value) {
    samples_.push_back(static_cast<std::uint8_t>(static_cast<unsigned>(*value) >> kDroppedBits));
  } else {
    failure_ = value.error();
  }
  return !is_done();
}

void AnalogRecorder::sample_due() {
  Task task;
  std::size_t due = 0;
  {
    const std::lock_guard lock(mutex_);
    if (is_done()) return;
    task = *task_;
    const auto passed = static_cast<std::size_t>((clock_.now() - task.start) / kSamplePeriod);
    due = std::min(passed, static_cast<std::size_t>(task.count)) - samples_.size();
  }
  while (due-- > 0 && sample(task)) {
  }
}

void AnalogRecorder::run(Task task) {
  pthread_setname_np(pthread_self(), "eb:record");
  Time due = task.start;
  do {
    due = std::max(due + kSamplePeriod, clock_.now());
    clock_.wait_until(due);
  } while (sample(task));
}

Result<std::vector<std::uint8_t>> AnalogRecorder::take(const WaitUntil& wait_until) {
  for (;;) {
    // Within a timer's function no other timer runs.
    if (clock_.is_virtual()) sample_due();
    Time next = clock_.now() + kSamplePeriod;
    {
      const std::lock_guard lock(mutex_);
      if (is_done()) break;
      next = std::max(next, task_->start + task_->count * kSamplePeriod);
    }
    wait_until(next);
  }
  std::vector<std::uint8_t> samples;
  std::optional<Error> failure;
  {
    const std::lock_guard lock(mutex_);
    samples.swap(samples_);
    failure.swap(failure_);
  }
  stop();
  if (failure) return tl::unexpected(*failure);
  return samples;
}

}  // namespace eyebridge::robios
