#include "clock/lockstep_clock.hpp"

#include <algorithm>
#include <utility>

namespace eyebridge::hal {

LockstepClock::LockstepClock(Time step, std::function<void()> step_world)
    : step_(step), step_world_(std::move(step_world)) {}

void LockstepClock::wait_until(Time deadline) {
  const std::lock_guard lock(mutex_);
  advance_to(deadline);
}

void LockstepClock::spend(Time cost) {
  const std::lock_guard lock(mutex_);
  advance_to(now() + std::max(cost, Time(0)));
}

void LockstepClock::advance_to(Time time) {
  if (time <= now()) return;
  while (time - world_time_ >= step_) {
    // Before the call: a step that throws has been begun, and must not be made again.
    world_time_ += step_;
    step_world_();
    now_.store(std::max(now(), world_time_).count(), std::memory_order_release);
  }
  now_.store(time.count(), std::memory_order_release);
}

}  // namespace eyebridge::hal
