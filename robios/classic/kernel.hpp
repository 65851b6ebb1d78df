#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "eyebot.h"
#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/result.hpp"

namespace eyebridge::robios::classic {

/// Thrown on the thread of a task that has ended, up to the C API, which ends the thread.
struct TaskEnded {};

/// Multitasking as eyebridge_classic/tasks.h describes it: each task is a thread, and one of them
/// runs at a time.
///
/// In virtual time who runs next depends on the robot's clock only. In real time a task that makes
/// no call for two slices computes on beside the next one, and waits for its turn at its next call:
/// so a loop that waits for a variable to change does not wait for ever.
/// Where tasks wait for each other they are out of the call (OutOfCall): so they take turns in
/// virtual time (robios/threads).
/// Any thread; what gives way must be called by a task that is not in a timer's function, and fails
/// with Unsupported otherwise.
class Kernel {
 public:
  /// What it needs of the session.
  struct Hooks {
    std::function<void(Time)> wait_until;  ///< On the robot's clock; timers run meanwhile.
    std::function<std::optional<Time>()> next_timer;  ///< When one is due, on a virtual clock.
    std::function<bool()> has_timers;                 ///< They may wake a task.
    std::function<void()> deadlock;  ///< All tasks wait for each other for ever; does not return.
  };

  /// Preemption looks at the clock this often, and a task's turn is this long.
  static constexpr Time kSlice = std::chrono::milliseconds(10);
  /// A task that was ready for so long is next, under preemption.
  static constexpr Time kStarved = std::chrono::seconds(10);

  Kernel(Clock& clock, Hooks hooks);
  ~Kernel();

  /// Makes the caller the first task. False when that was done before.
  bool start(bool preemptive);
  [[nodiscard]] bool started() const { return started_; }
  [[nodiscard]] bool preemptive() const { return preemptive_; }

  /// Calls of the API begin with this, on every thread: takes turns under preemption. Throws
  /// TaskEnded.
  void enter();
  /// … and end with this.
  void leave();
  /// Waits until a moment on the robot's clock; other tasks run meanwhile if that is permitted.
  /// Throws TaskEnded, as all that follow and give way.
  void wait_until(Time deadline);

  Result<tcb*> spawn(const std::string& name, void (*code)(), int stack_size, int priority,
                     int uid);
  // `task` null is the caller. All fail with OutOfRange for what is no task or has ended.
  Result<void> ready(tcb* task);
  Result<void> suspend(tcb* task);
  Result<void> join(tcb* task);
  /// Ends another task; of the caller itself throws TaskEnded.
  Result<void> kill(tcb* task);
  Result<int> uid(tcb* task);
  Result<std::string> name(tcb* task);
  [[nodiscard]] bool is_main() const;

  Result<void> reschedule();
  Result<void> sleep_until(Time deadline);
  /// Fails with Unsupported when the mode is cooperative.
  Result<void> permit();
  void forbid();
  /// Nobody is preempted until it is off again, whatever permit() says.
  void disable(bool on);

  void set(sem& semaphore, int value);
  Result<void> take(sem& semaphore);
  void give(sem& semaphore);

 private:
  enum class State { New, Ready, Running, Suspended, Sleeping, AtSemaphore, Ended };
  struct Task;
  using Lock = std::unique_lock<std::mutex>;

  static void* thread_of(void* task);
  [[nodiscard]] static Task* self();
  void show(Task& task, State state);
  void make_ready(Task& task);
  [[nodiscard]] Result<Task*> find(tcb* task);
  [[nodiscard]] Result<Task*> caller();
  [[nodiscard]] Task* best_ready() const;
  [[nodiscard]] bool preempts() const { return preemptive_ && permitted_ && !disabled_; }
  void wake_sleepers();
  void hand_over(Lock& lock);
  void idle(Lock& lock);
  void give_way(Task& me, Lock& lock);
  void await_turn(Task& me, Lock& lock);
  void watch();

  Clock& clock_;
  const Hooks hooks_;
  mutable std::mutex mutex_;
  std::map<const tcb*, std::unique_ptr<Task>> tasks_;
  Task* running_ = nullptr;  ///< Whose turn it is.
  Time turn_began_{0};
  long long order_ = 0;  ///< Of those that became ready, fell asleep, or wait.
  std::atomic<bool> started_ = false;
  bool preemptive_ = false;
  bool permitted_ = false;
  bool disabled_ = false;
  bool watched_ = false;
};

}  // namespace eyebridge::robios::classic
