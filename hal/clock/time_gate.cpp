#include "clock/time_gate.hpp"

#include <algorithm>

#include "clock/check_factor.hpp"

namespace eyebridge::hal {

void TimeGate::pause() {
  const std::lock_guard lock(mutex_);
  is_paused_ = true;
  single_steps_ = 0;
  change();
}

void TimeGate::resume() {
  const std::lock_guard lock(mutex_);
  is_paused_ = false;
  change();
}

bool TimeGate::is_paused() const {
  const std::lock_guard lock(mutex_);
  return is_paused_;
}

void TimeGate::step() {
  const std::lock_guard lock(mutex_);
  if (is_paused_) ++single_steps_;
  change();
}

double TimeGate::factor() const {
  const std::lock_guard lock(mutex_);
  return factor_;
}

Result<void> TimeGate::set_factor(double factor) {
  if (factor != kFastest) {
    if (auto good = check_factor(factor); !good) return good;
  }
  const std::lock_guard lock(mutex_);
  factor_ = factor;
  change();
  return {};
}

void TimeGate::change() {
  is_open_.store(!is_paused_ && factor_ == kFastest, std::memory_order_release);
  next_ = Wall::now();
  changed_.notify_all();
}

void TimeGate::wait() {
  std::unique_lock lock(mutex_);
  for (;;) {
    if (is_paused_) {
      if (single_steps_ > 0) {
        --single_steps_;
        return;
      }
      changed_.wait(lock);
      continue;
    }
    if (factor_ == kFastest) return;
    const auto now = Wall::now();
    if (now >= next_) {
      const std::chrono::duration<double, std::nano> pause = step_ / factor_;
      // Who is late does not catch up: the person looks at what happens now.
      next_ = std::max(next_, now - std::chrono::milliseconds(100)) +
              std::chrono::duration_cast<Wall::duration>(pause);
      return;
    }
    changed_.wait_until(lock, next_);
  }
}

}  // namespace eyebridge::hal
