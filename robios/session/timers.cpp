#include "timers.hpp"

#include <algorithm>
#include <exception>
#include <utility>
#include <vector>

#include <cxxabi.h>
#include <pthread.h>

#include "flow.hpp"

namespace eyebridge::robios {
namespace {

// How often the timer thread looks again: a timer attached meanwhile is late by this at most.
constexpr Time kLookAgain = std::chrono::milliseconds(1);

/// An exception has nobody who could catch it, also where the program called OSWait() meanwhile:
/// on every clock it ends the program, as one that leaves a thread does.
void call(const std::function<void()>& callback) {
  try {
    callback();
  } catch (const abi::__forced_unwind&) {  // pthread_exit()
    throw;
  } catch (...) {
    std::terminate();
  }
}

}  // namespace

Timers::Timers(Clock& clock) : clock_(clock) {}

Timers::~Timers() {
  stop();
  if (!thread_.joinable()) return;
  if (thread_.get_id() == std::this_thread::get_id()) {
    thread_.detach();  // a callback called exit(): this thread cannot wait for itself
  } else {
    thread_.join();
  }
}

int Timers::attach(Time period, Callback callback) {
  const std::lock_guard lock(mutex_);
  const int handle = next_handle_++;
  entries_.emplace(handle, Entry{period, clock_.now() + period, std::move(callback)});
  any_ = true;
  if (!clock_.is_virtual() && !thread_.joinable() && !stopping_) {
    thread_ = std::thread([this] { run_thread(); });
  }
  changed_.notify_all();
  return handle;
}

bool Timers::detach(int handle) {
  const std::lock_guard lock(mutex_);
  return entries_.erase(handle) != 0;
}

void Timers::stop() {
  const std::lock_guard lock(mutex_);
  stopping_ = true;
  changed_.notify_all();
}

void Timers::let_go() {
  stop();
  const std::lock_guard lock(mutex_);
  if (thread_.joinable()) thread_.detach();
}

// A callback that calls the API must not start callbacks itself.
bool Timers::is_calling() { return flow.in_timer; }

void Timers::hold(bool on) {
  const std::lock_guard lock(mutex_);
  held_ = on;
  changed_.notify_all();
}

void Timers::finish() {
  stop();
  if (flow.in_timer) return;
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !calling_; });
}

std::optional<Time> Timers::earliest() const {
  if (held_) return std::nullopt;
  std::optional<Time> first;
  for (const auto& [handle, entry] : entries_) {
    if (!first || entry.due < *first) first = entry.due;
  }
  return first;
}

std::optional<Time> Timers::next_due() const {
  if (!any() || !clock_.is_virtual() || flow.in_timer) return std::nullopt;
  const std::lock_guard lock(mutex_);
  return stopping_ || calling_ ? std::nullopt : earliest();
}

void Timers::run_due() {
  if (!any() || !clock_.is_virtual() || flow.in_timer) return;
  std::unique_lock lock(mutex_);
  if (stopping_ || held_ || calling_ || entries_.empty()) return;
  call_due(clock_.now(), lock);
}

void Timers::call_due(Time now, std::unique_lock<std::mutex>& lock) {
  std::vector<Callback> due;
  for (auto& [handle, entry] : entries_) {
    if (entry.due > now) continue;
    due.push_back(entry.callback);
    const auto missed = (now - entry.due) / entry.period;
    entry.due += (missed + 1) * entry.period;
  }
  if (due.empty()) return;
  calling_ = true;
  lock.unlock();
  flow.in_timer = true;
  for (const Callback& callback : due) call(callback);
  flow.in_timer = false;
  lock.lock();
  calling_ = false;
  changed_.notify_all();
}

void Timers::run_thread() {
  pthread_setname_np(pthread_self(), "eb:timers");
  std::unique_lock lock(mutex_);
  while (!stopping_) {
    const std::optional<Time> due = earliest();
    if (!due) {
      changed_.wait(lock);
      continue;
    }
    const Time now = clock_.now();
    if (*due <= now) {
      call_due(now, lock);
      continue;
    }
    lock.unlock();
    clock_.wait_until(std::min(*due, now + kLookAgain));
    lock.lock();
  }
}

}  // namespace eyebridge::robios
