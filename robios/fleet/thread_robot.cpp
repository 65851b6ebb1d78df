#include "thread_robot.hpp"

#include <chrono>
#include <optional>
#include <system_error>

#include <pthread.h>
#include <unistd.h>

#include "crash_handler.hpp"
#include "fiber.hpp"

namespace eyebridge::robios {

bool Barrier::join() {
  const std::lock_guard lock(mutex_);
  if (left_ == 0) return false;
  ++left_;
  return true;
}

bool Barrier::await_start(double seconds) {
  std::unique_lock lock(mutex_);
  return changed_.wait_for(lock, std::chrono::duration<double>(seconds),
                           [this] { return awaited_ == 0; });
}

void Barrier::await_end() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return left_ == 0; });
}

std::size_t Barrier::awaited() {
  const std::lock_guard lock(mutex_);
  return awaited_;
}

void ThreadRobot::start() {
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, Fiber::kStackSize + Fiber::kGuardSize);
  pthread_attr_setguardsize(&attributes, Fiber::kGuardSize);
  pthread_t thread{};
  const int error = pthread_create(
      &thread, &attributes,
      [](void* robot) -> void* {
        auto& me = *static_cast<ThreadRobot*>(robot);
        // Where the program is another process no crash of it comes here.
        std::optional<CrashStack> stack;
        if (!me.has_process()) stack.emplace();
        me.tid_ = gettid();
        me.run();
      },
      this);
  pthread_attr_destroy(&attributes);
  if (error != 0) throw std::system_error(error, std::generic_category(), "a robot's thread");
  pthread_detach(thread);
}

void ThreadRobot::arrive() {
  if (has_arrived_.exchange(true)) return;
  barrier_.arrive([this] { world_.begin_time(); });
}

void ThreadRobot::drop(int code) {
  if (end(code)) forget();
  // Where the program is another process nothing of it is on this stack. Robots may come and go all
  // day long.
  if (has_process()) pthread_exit(nullptr);
  hold_thread();
}

void ThreadRobot::forget() {
  barrier_.leave(has_arrived_.exchange(true), [this] { world_.begin_time(); });
}

// Not pthread_exit(): it unwinds the program's stack, through functions that may not throw.
void ThreadRobot::hold_thread() {
  for (;;) pause();
}

}  // namespace eyebridge::robios
