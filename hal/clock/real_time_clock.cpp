#include "clock/real_time_clock.hpp"

#include <algorithm>
#include <future>
#include <utility>

#include <pthread.h>

#include "clock/check_factor.hpp"

namespace eyebridge::hal {
namespace {

// Short enough not to be felt when time slips, long enough for what a desktop's scheduler does.
constexpr std::chrono::duration<double, std::nano> kLongestWallLag{100e6};
constexpr int kFewestLagSteps = 10;
// A world that is too slow even so would leave the others no processor.
constexpr std::uint64_t kMostUrgentOverruns = 3;

Time longest_lag(Time step, double factor) {
  const auto lag = std::chrono::duration_cast<Time>(kLongestWallLag * factor);
  return std::max(lag, kFewestLagSteps * step);
}

}  // namespace

RealTimeClock::RealTimeClock(Time step, double factor, std::function<void()> step_world,
                             Start start)
    : step_(step),
      step_world_(std::move(step_world)),
      factor_(factor),
      longest_lag_(longest_lag(step, factor)),
      anchor_wall_(Wall::now()),
      begun_(start == Start::AtOnce) {
  std::promise<ThreadPriority> granted;
  thread_ = std::thread([this, &granted] {
    granted.set_value(raise_priority());
    run();
  });
  priority_ = granted.get_future().get();
  // By this name robios knows that it is none of the program's own threads.
  pthread_setname_np(thread_.native_handle(), "eb:world");
}

RealTimeClock::~RealTimeClock() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

Time RealTimeClock::now() const {
  const std::lock_guard lock(mutex_);
  return shown();
}

Time RealTimeClock::at(Time moment) const {
  const std::lock_guard lock(mutex_);
  return std::min(scaled(Wall::time_point(moment)), latest());
}

void RealTimeClock::wait_until(Time deadline) {
  std::unique_lock lock(mutex_);
  if (shown() >= deadline) return;
  const auto mine = deadlines_.insert(deadline);
  while (shown() < deadline) {
    if (stands() || latest() < deadline) {
      stepped_.wait(lock);
    } else {
      stepped_.wait_until(lock, wall_of(deadline));
    }
  }
  deadlines_.erase(mine);
}

void RealTimeClock::begin() { start_or_stop(begun_, true); }
void RealTimeClock::pause() { start_or_stop(paused_, true); }
void RealTimeClock::resume() { start_or_stop(paused_, false); }

void RealTimeClock::start_or_stop(bool& flag, bool value) {
  {
    const std::lock_guard lock(mutex_);
    if (flag == value) return;
    anchor(shown());
    flag = value;
  }
  changed_.notify_all();
  stepped_.notify_all();
}

bool RealTimeClock::is_paused() const {
  const std::lock_guard lock(mutex_);
  return paused_;
}

void RealTimeClock::step() {
  {
    const std::lock_guard lock(mutex_);
    if (!stands()) return;
    anchor_time_ += step_;  // the world's thread follows
  }
  changed_.notify_all();
}

double RealTimeClock::factor() const {
  const std::lock_guard lock(mutex_);
  return factor_;
}

Result<void> RealTimeClock::set_factor(double factor) {
  if (auto good = check_factor(factor); !good) return good;
  {
    const std::lock_guard lock(mutex_);
    anchor(shown());
    factor_ = factor;
    longest_lag_ = longest_lag(step_, factor);
  }
  changed_.notify_all();
  stepped_.notify_all();
  return {};
}

std::uint64_t RealTimeClock::overruns() const {
  const std::lock_guard lock(mutex_);
  return overruns_;
}

void RealTimeClock::run() {
  std::unique_lock lock(mutex_);
  while (!ending_) {
    const Time due = world_time_ + step_;
    if (scaled() < due) {
      if (stands()) {
        changed_.wait(lock);
      } else {
        changed_.wait_until(lock, wall_of(due));
      }
      continue;
    }
    if (scaled() - world_time_ > longest_lag_) {
      anchor(due);
      if (++overruns_ == kMostUrgentOverruns) restore_priority(priority_);
    }
    lock.unlock();
    step_world_();
    lock.lock();
    world_time_ = due;
    if (!deadlines_.empty() && *deadlines_.begin() <= latest()) stepped_.notify_all();
  }
}

Time RealTimeClock::scaled(Wall::time_point moment) const {
  if (stands() && moment > anchor_wall_) return anchor_time_;
  const std::chrono::duration<double, std::nano> passed = moment - anchor_wall_;
  return anchor_time_ + std::chrono::duration_cast<Time>(passed * factor_);
}

Time RealTimeClock::latest() const { return world_time_ + step_ - Time(1); }

Time RealTimeClock::shown() const { return std::min(scaled(), latest()); }

RealTimeClock::Wall::time_point RealTimeClock::wall_of(Time time) const {
  const std::chrono::duration<double, std::nano> ahead = (time - anchor_time_) / factor_;
  // Rounded up, so that the moment has come when the wait ends.
  return anchor_wall_ + std::chrono::ceil<Wall::duration>(ahead);
}

void RealTimeClock::anchor(Time time) {
  anchor_time_ = time;
  anchor_wall_ = Wall::now();
}

}  // namespace eyebridge::hal
