// The life of tasks, and semaphores; who runs when is in kernel.cpp.

#include <algorithm>
#include <cassert>
#include <thread>

#include <fmt/format.h>
#include <pthread.h>

#include "flow.hpp"
#include "kernel.hpp"
#include "task.hpp"

namespace eyebridge::robios::classic {
namespace {

// Programs say 4096 bytes, as on the robot, where a frame of theirs is a tenth of what it is here.
constexpr std::size_t kStackSize = std::size_t{8} << 20;
constexpr int kMostTasks = 1000;

}  // namespace

Kernel::Task* Kernel::self() { return static_cast<Task*>(flow.kernel_task); }

bool Kernel::start(bool preemptive) {
  const Lock lock(mutex_);
  if (started_) return false;
  auto task = std::make_unique<Task>();
  task->kernel = this;
  task->name = "main";
  task->shown.name = task->name.c_str();
  task->shown.pri = IDLE_PRI;
  task->is_main = true;
  show(*task, State::Running);
  running_ = task.get();
  turn_began_ = clock_.now();
  flow.kernel_task = task.get();
  tasks_.emplace(&task->shown, std::move(task));
  preemptive_ = preemptive;
  started_ = true;
  return true;
}

Result<tcb*> Kernel::spawn(const std::string& name, void (*code)(), int stack_size, int priority,
                           int uid) {
  const Lock lock(mutex_);
  if (!started_) return fail(Errc::Unsupported, "there are no tasks: call OSMTInit first");
  const auto alive = std::ranges::count_if(
      tasks_, [](const auto& entry) { return entry.second->state != State::Ended; });
  if (alive > kMostTasks) return fail(Errc::Unsupported, "there are 1000 tasks already");
  auto task = std::make_unique<Task>();
  task->kernel = this;
  task->name = name;
  task->shown.name = task->name.c_str();
  task->shown.stksiz = stack_size;
  task->shown.pri = priority;
  task->shown.uid = uid;
  task->code = code;

  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(
      &attributes, std::max(kStackSize, static_cast<std::size_t>(std::max(stack_size, 0))));
  pthread_attr_setdetachstate(&attributes, PTHREAD_CREATE_DETACHED);
  pthread_t thread{};
  const int failure = [&] {
    const OutOfCall program;
    return pthread_create(&thread, &attributes, thread_of, task.get());
  }();
  pthread_attr_destroy(&attributes);
  if (failure != 0) return fail(Errc::Unsupported, "the system gives no thread for the task");
  tcb* const shown = &task->shown;
  tasks_.emplace(shown, std::move(task));
  return shown;
}

void* Kernel::thread_of(void* given) {
  Task& me = *static_cast<Task*>(given);
  flow.kernel_task = given;
  Kernel& kernel = *me.kernel;
  try {
    {
      const InCall in_call;
      Lock lock(kernel.mutex_);
      kernel.await_turn(me, lock);
    }
    me.code();
    const InCall in_call;
    static_cast<void>(kernel.kill(nullptr));
  } catch (const TaskEnded&) {
    return nullptr;
  }
  return nullptr;
}

Result<void> Kernel::kill(tcb* task) {
  Lock lock(mutex_);
  const Result<Task*> found = find(task);
  if (!found) return tl::unexpected(found.error());
  Task& ended = **found;
  if (ended.state == State::AtSemaphore) --ended.waits_at->waitq.threads;
  show(ended, State::Ended);
  if (&ended != self()) {
    ended.notify();
    return {};
  }
  if (running_ == &ended) hand_over(lock);
  throw TaskEnded{};
}

Result<void> Kernel::join(tcb* task) {
  if (task == nullptr) return fail(Errc::OutOfRange, "a task cannot wait for its own end");
  for (;;) {
    {
      const Lock lock(mutex_);
      const auto found = tasks_.find(task);
      if (found == tasks_.end()) return fail(Errc::OutOfRange, "there is no such task");
      if (found->second->state == State::Ended) return {};
    }
    if (Result<void> slept = sleep_until(clock_.now() + kSlice); !slept) return slept;
  }
}

void Kernel::set(sem& semaphore, int value) {
  const Lock lock(mutex_);
  semaphore = {};
  semaphore.count = value;
}

Result<void> Kernel::take(sem& semaphore) {
  Lock lock(mutex_);
  if (semaphore.count > 0) {
    --semaphore.count;
    return {};
  }
  if (started_) {
    return caller().map([&](Task* me) {
      ++semaphore.waitq.threads;
      me->waits_at = &semaphore;
      me->order = ++order_;
      me->has_waited = true;
      show(*me, State::AtSemaphore);
      give_way(*me, lock);
    });
  }
  // Without tasks only a timer can give.
  while (semaphore.count <= 0) idle(lock);
  --semaphore.count;
  return {};
}

void Kernel::give(sem& semaphore) {
  const Lock lock(mutex_);
  Task* first = nullptr;
  for (const auto& [shown, task] : tasks_) {
    if (task->state != State::AtSemaphore || task->waits_at != &semaphore) continue;
    if (first == nullptr || task->order < first->order) first = task.get();
  }
  if (first == nullptr) {
    ++semaphore.count;
    return;
  }
  --semaphore.waitq.threads;
  first->waits_at = nullptr;
  if (first->suspended) {
    first->suspended = false;
    show(*first, State::Suspended);
  } else {
    make_ready(*first);
  }
}

void Kernel::watch() {
  if (watched_ || clock_.is_virtual()) return;
  watched_ = true;
  std::thread([this] {
    pthread_setname_np(pthread_self(), "eb:tasks");
    for (;;) {
      clock_.wait_until(clock_.now() + kSlice);
      const Lock lock(mutex_);
      if (!preempts() || running_ == nullptr || clock_.now() - turn_began_ < 2 * kSlice) continue;
      wake_sleepers();
      Task* const next = best_ready();
      if (next == nullptr || next->priority() < running_->priority()) continue;
      make_ready(*running_);
      running_ = next;
      turn_began_ = clock_.now();
      show(*next, State::Running);
      next->notify();
    }
  }).detach();
}

}  // namespace eyebridge::robios::classic
