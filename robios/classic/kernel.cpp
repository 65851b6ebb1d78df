#include "kernel.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "flow.hpp"
#include "task.hpp"

namespace eyebridge::robios::classic {
namespace {

tl::unexpected<Error> no_task() { return fail(Errc::OutOfRange, "there is no such task"); }

}  // namespace

Kernel::Kernel(Clock& clock, Hooks hooks) : clock_(clock), hooks_(std::move(hooks)) {}

Kernel::~Kernel() = default;

void Kernel::show(Task& task, State state) {
  task.state = state;
  switch (state) {
    case State::New:
      task.shown.stat = TASK_NEW;
      break;
    case State::Ready:
      task.shown.stat = TASK_READY;
      break;
    case State::Running:
      task.shown.stat = TASK_RUNNING;
      break;
    default:
      task.shown.stat = TASK_SUSPEND;
  }
  task.shown.semq = state == State::AtSemaphore ? task.waits_at : nullptr;
}

void Kernel::make_ready(Task& task) {
  task.order = ++order_;
  task.ready_since = clock_.now();
  show(task, State::Ready);
}

Result<Kernel::Task*> Kernel::find(tcb* task) {
  if (task == nullptr) return caller();
  const auto found = tasks_.find(task);
  if (found == tasks_.end()) return no_task();
  if (found->second->state == State::Ended) {
    return fail(Errc::OutOfRange, fmt::format("the task '{}' has ended", found->second->name));
  }
  return found->second.get();
}

Result<Kernel::Task*> Kernel::caller() {
  if (!started_) return fail(Errc::Unsupported, "there are no tasks: call OSMTInit first");
  if (self() == nullptr || flow.kernel_calls > 1) {
    return fail(Errc::Unsupported, "not possible in the function of a timer, which is no task");
  }
  return self();
}

bool Kernel::is_main() const { return self() == nullptr || self()->is_main; }

void Kernel::enter() {
  ++flow.kernel_calls;
  if (!started_ || self() == nullptr || flow.kernel_calls > 1) return;
  Task& me = *self();
  Lock lock(mutex_);
  await_turn(me, lock);
  if (!preempts() || clock_.now() - turn_began_ < kSlice) return;
  make_ready(me);
  give_way(me, lock);
}

void Kernel::leave() { --flow.kernel_calls; }

Kernel::Task* Kernel::best_ready() const {
  Task* best = nullptr;
  const Time now = clock_.now();
  const auto rank = [&](const Task& task) {
    const bool starved = preempts() && now - task.ready_since >= kStarved;
    return starved ? MAX_PRI + 1 : task.priority();
  };
  for (const auto& [shown, task] : tasks_) {
    if (task->state != State::Ready) continue;
    if (best == nullptr || rank(*task) > rank(*best) ||
        (rank(*task) == rank(*best) && task->order < best->order)) {
      best = task.get();
    }
  }
  return best;
}

void Kernel::wake_sleepers() {
  std::vector<Task*> due;
  for (const auto& [shown, task] : tasks_) {
    if (task->state == State::Sleeping && task->wake <= clock_.now()) due.push_back(task.get());
  }
  std::ranges::sort(due, [](const Task* a, const Task* b) {
    return a->wake != b->wake ? a->wake < b->wake : a->order < b->order;
  });
  for (Task* task : due) make_ready(*task);
}

void Kernel::idle(Lock& lock) {
  std::optional<Time> until;
  for (const auto& [shown, task] : tasks_) {
    if (task->state == State::Sleeping && (!until || task->wake < *until)) until = task->wake;
  }
  const bool hopeless = !until && !hooks_.has_timers();
  lock.unlock();  // timers that run meanwhile may wake a task
  if (hopeless) hooks_.deadlock();
  if (!clock_.is_virtual()) {
    const Time soon = clock_.now() + kSlice;
    until = until ? std::min(*until, soon) : soon;
  } else if (const std::optional<Time> timer = hooks_.next_timer(); timer) {
    until = until ? std::min(*until, *timer) : *timer;
  }
  // Timers that are held (OSDisable) leave nothing to wait for.
  if (!until) hooks_.deadlock();
  hooks_.wait_until(*until);
  lock.lock();
}

void Kernel::hand_over(Lock& lock) {
  running_ = nullptr;
  Task* next = nullptr;
  for (;;) {
    wake_sleepers();
    next = best_ready();
    if (next != nullptr) break;
    idle(lock);
  }
  running_ = next;
  turn_began_ = clock_.now();
  show(*next, State::Running);
  next->notify();
}

void Kernel::await_turn(Task& me, Lock& lock) {
  {
    const OutOfCall program;
    me.turn.wait(lock, [&] { return running_ == &me || me.state == State::Ended; });
  }
  if (me.state == State::Ended) throw TaskEnded{};
}

void Kernel::give_way(Task& me, Lock& lock) {
  // In real time somebody else may have been given the turn already: see watch().
  if (running_ == &me) hand_over(lock);
  await_turn(me, lock);
}

void Kernel::wait_until(Time deadline) {
  Task* const me = self();
  if (me != nullptr && flow.kernel_calls <= 1) {
    Lock lock(mutex_);
    if (preempts()) {
      me->wake = deadline;
      me->order = ++order_;
      me->has_waited = true;
      show(*me, State::Sleeping);
      give_way(*me, lock);
      return;
    }
    me->has_waited = true;
  }
  hooks_.wait_until(deadline);
}

Result<void> Kernel::sleep_until(Time deadline) {
  Lock lock(mutex_);
  return caller().map([&](Task* me) {
    me->wake = deadline;
    me->order = ++order_;
    me->has_waited = true;
    show(*me, State::Sleeping);
    give_way(*me, lock);
  });
}

Result<void> Kernel::reschedule() {
  Lock lock(mutex_);
  return caller().map([&](Task* me) {
    me->has_waited = false;
    make_ready(*me);
    give_way(*me, lock);
  });
}

Result<void> Kernel::permit() {
  if (started_ && !preemptive_) {
    return fail(Errc::Unsupported, "OSMTInit said COOP: there is no preemption");
  }
  {
    const Lock lock(mutex_);
    if (Result<Task*> me = caller(); !me) return tl::unexpected(me.error());
    permitted_ = true;
    watch();
  }
  return reschedule();
}

void Kernel::forbid() {
  const Lock lock(mutex_);
  permitted_ = false;
}

void Kernel::disable(bool on) {
  const Lock lock(mutex_);
  disabled_ = on;
}

Result<void> Kernel::ready(tcb* task) {
  const Lock lock(mutex_);
  return find(task).map([&](Task* found) {
    found->suspended = false;
    if (found->state == State::New || found->state == State::Suspended ||
        found->state == State::Sleeping) {
      make_ready(*found);
    }
  });
}

Result<void> Kernel::suspend(tcb* task) {
  Lock lock(mutex_);
  return find(task).map([&](Task* found) {
    if (found->state == State::AtSemaphore) {
      found->suspended = true;
      return;
    }
    show(*found, State::Suspended);
    if (found == self()) give_way(*found, lock);
  });
}

Result<int> Kernel::uid(tcb* task) {
  const Lock lock(mutex_);
  return find(task).map([](const Task* found) { return found->shown.uid; });
}

Result<std::string> Kernel::name(tcb* task) {
  const Lock lock(mutex_);
  return find(task).map([](const Task* found) { return found->name; });
}

}  // namespace eyebridge::robios::classic
