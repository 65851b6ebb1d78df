#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <thread>

#include "eyebridge/base/clock.hpp"

namespace eyebridge::robios {

/// Functions called every so often: OSAttachTimer().
///
/// On a clock that runs by itself they are called from a thread of their own, beside the program,
/// as on the robot. On a virtual clock they are called by run_due(), between two calls of the
/// program. A timer that is late is called once, not once for each period missed. Any thread.
class Timers {
 public:
  using Callback = std::function<void()>;

  explicit Timers(Clock& clock);
  ~Timers();

  /// Calls `callback` every `period` (> 0), first one period from now. Returns a handle > 0.
  int attach(Time period, Callback callback);
  /// False when there is no such timer. The callback may still be running when this returns.
  bool detach(int handle);

  /// Calls nothing from now on; what comes due meanwhile is made up for, once, when it is held no
  /// longer. For programs that disable interrupts.
  void hold(bool on);

  /// False as long as there was never one.
  [[nodiscard]] bool any() const { return any_.load(std::memory_order_relaxed); }
  /// Runs what is due on a virtual clock; does nothing on others, nor inside a callback.
  void run_due();
  /// When the next timer is due on a virtual clock.
  [[nodiscard]] std::optional<Time> next_due() const;
  /// True in a callback: the calling thread is one's.
  [[nodiscard]] static bool is_calling();
  /// Ends the thread; no callback starts after this.
  void stop();
  /// stop(), of timers that are never destroyed: nobody waits for the thread's end.
  void let_go();
  /// stop(), and waits for the callback that is running now; not from inside a callback.
  void finish();

 private:
  struct Entry {
    Time period;
    Time due;
    Callback callback;
  };

  [[nodiscard]] std::optional<Time> earliest() const;
  void call_due(Time now, std::unique_lock<std::mutex>& lock);
  void run_thread();

  std::atomic<bool> any_ = false;
  Clock& clock_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::map<int, Entry> entries_;
  int next_handle_ = 1;
  bool stopping_ = false;
  bool held_ = false;
  bool calling_ = false;  ///< One thread is in callbacks: as on the robot, never two at once.
  std::thread thread_;
};

}  // namespace eyebridge::robios
