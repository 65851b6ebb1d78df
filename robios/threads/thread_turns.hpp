#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <utility>

#include "eyebridge/base/clock.hpp"
#include "thread_state.hpp"
#include "wake_up.hpp"

namespace eyebridge::robios {

struct TurnMember;

/// Lets the threads of the process's only program take turns in virtual time, so that time passes
/// for all of them at once, and runs repeat: one goes on at a time, the one that waits for the
/// earliest moment; of several that do, the one that was made first.
///
/// They are threads of the system, so that whatever they do works. Who waits otherwise than here
/// (reads a file, waits in a lock that is not told of) sleeps, by the kernel's word, and the others
/// go on without it; not so in a call of the library, where who sleeps waits for an answer that
/// comes, unless the call says that it may not (Away). Who computes holds time up, for kPatience_s
/// of processor time; who did that once, for kLessPatience_s: it spins until others have done
/// something, and will again.
///
/// Any thread. A member is one thread's, which alone calls what takes it, but for leave().
class ThreadTurns {
 public:
  static constexpr Time kNever = Time::max();
  static constexpr double kPatience_s = 2.0;
  static constexpr double kLessPatience_s = 0.02;

  /// A thread of the program.
  using Member = TurnMember;
  /// Tells whether `what` need not be waited for; `value` as it was given.
  using IsFree = int (*)(const void* what, long value);
  using Look = std::function<ThreadState(Member&)>;
  /// Told when a thread has computed too long for the first time: time goes on without it.
  using Tell = std::function<void()>;

  /// What else happens on the clock, and may wake somebody: a timer's function.
  struct Events {
    std::function<std::optional<Time>()> next = [] { return std::nullopt; };
    /// Lets happen what is due. A member calls it, in its turn.
    std::function<void()> run = [] {};
  };

  /// `look`: what a member does that is not here. When all wait for each other for ever, time goes
  /// on from event to event.
  ThreadTurns(Look look, Tell tell, Events events);
  ThreadTurns(Look look, Tell tell) : ThreadTurns(std::move(look), std::move(tell), Events()) {}
  ~ThreadTurns();
  ThreadTurns(const ThreadTurns&) = delete;
  ThreadTurns& operator=(const ThreadTurns&) = delete;

  /// Turns begin, on this clock, which is lent; before, members come and go, and that is all.
  void begin(Clock& clock);
  [[nodiscard]] bool have_begun() const { return clock_ != nullptr && !has_ended_; }
  /// There are none any more: whoever waits goes on as if it were woken, and nobody waits again.
  void end();
  /// True while nobody has to be asked.
  [[nodiscard]] bool is_alone() const { return count_.load(std::memory_order_relaxed) < 2; }

  /// A thread that is about to be started by the calling one. It takes its first turn in start().
  Member& expect();
  /// What an expected thread does first.
  void start(Member& me);
  /// A thread that runs already, not as a member: `tid` as gettid(2) has it. The same one when it
  /// is a member.
  Member& adopt(int tid);
  /// Its pthread_t, for whoever waits for its end; nothing when it has left already.
  void name(const Member& member, unsigned long thread);
  /// It ends, or was never started.
  void leave(Member& member);

  /// Before and after fork(2), in the calling thread: nobody else has the lock.
  void before_fork() { mutex_.lock(); }
  void after_fork() { mutex_.unlock(); }
  void after_fork_in_child() {
    entering_ = 0;  // who waited is not there
    mutex_.unlock();
  }

  /// Returns when the clock is at `deadline` and it is the caller's turn. A cancellation point.
  void wait(Member& me, Time deadline);
  /// What may end a park besides a wake().
  struct Unless {
    IsFree is_free = nullptr;
    long value = 0;
    bool is_watched = false;       ///< Asked later, too: who is no member may change it.
    bool is_from_outside = false;  ///< Also a signal's handler, or another process, at any time.
  };
  /// The same, or when somebody wakes `what`; true when the deadline came first. Not at all when
  /// `unless` says so: nobody can wake it between that look and the wait.
  bool park(Member& me, const void* what, Time deadline, const Unless& unless);
  bool park(Member& me, const void* what, Time deadline) { return park(me, what, deadline, {}); }
  /// Who parked at `what` first, or all, go on at the present time, each in its turn.
  void wake(const void* what, bool all);

  /// Within a call it waited for what others may have to do first, and they could go on: unless
  /// nobody did, this is as wait() for the present moment.
  void come_back(Member& me);

  /// The one with this name is cancelled: it waits no longer.
  void cancel(unsigned long thread);

  /// All wait for ever, for each other. Any thread.
  [[nodiscard]] bool are_stuck();

  enum class Ended { Yes, Late, Unknown };
  /// For join(): parks until the member with this name has left, once, or until `deadline` (Late).
  /// Unknown when nobody had this name, or there are no turns any more.
  Ended await_end(Member& me, unsigned long thread, Time deadline = kNever);

  [[nodiscard]] Time now() const { return clock()->now(); }

 private:
  using Lock = std::unique_lock<std::mutex>;

  [[nodiscard]] Clock* clock() const { return clock_.load(std::memory_order_acquire); }
  [[nodiscard]] Lock enter();
  [[nodiscard]] bool is_busy(Member& member);
  [[nodiscard]] Member* first_waiting();
  std::shared_ptr<WakeUp> pass_on();
  bool park_in(Member& me, Lock& lock, const void* what, Time deadline, const Unless& unless);
  [[nodiscard]] bool all_wait() const;
  void wake_by_others();
  void await_turn(Member& me, Lock& lock);
  void wake_locked(const void* what, bool all);
  void wake_member(Member& member) const;
  void forget_gone();

  const Look look_;
  const Tell tell_;
  const Events events_;
  std::mutex mutex_;
  std::atomic<int> entering_ = 0;  ///< Who waits for the lock: he goes on.
  std::list<Member> members_;      ///< In the order they were made.
  std::atomic<std::size_t> count_ = 0;
  std::set<unsigned long> left_;  ///< Names of those who have, and were not waited for.
  std::uint64_t arrivals_ = 0;
  std::atomic<Clock*> clock_ = nullptr;
  std::atomic<bool> has_ended_ = false;
};

/// A thread of the program, as its ThreadTurns has it, which alone reads and writes this.
struct TurnMember {
  enum class Stage {
    Out,      ///< Runs, or waits for something else.
    Waiting,  ///< For its turn.
    Going,    ///< It is its turn; it lets time pass, and is Out then.
    Gone,
  };

  std::atomic<int> tid = 0;  ///< 0: not started yet.
  /// It sleeps for what comes by itself. The thread's own flow writes it (flow.hpp).
  std::atomic<bool> is_in_call = false;
  unsigned long thread = 0;  ///< As pthread_t; 0: not known.
  std::atomic<Stage> stage = Stage::Out;
  Time deadline = ThreadTurns::kNever;  ///< While it waits.
  ThreadTurns::Unless unless;           ///< What may end its wait besides a wake().
  const void* what = nullptr;           ///< At which it parked.
  std::optional<Time> event;  ///< It is its turn for what happens then; it goes on waiting.
  std::uint64_t arrival = 0;
  bool was_woken = false;
  bool was_passed = false;               ///< Others went on while it slept somewhere else.
  bool is_left_alone = false;            ///< It has computed too long; until it is here again.
  std::optional<double> computes_since;  ///< Its processor time when it was first seen to.
  double patience_s = ThreadTurns::kPatience_s;  ///< With it when it computes.
  const std::shared_ptr<WakeUp> turn = std::make_shared<WakeUp>();
};

}  // namespace eyebridge::robios
