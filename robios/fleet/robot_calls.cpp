#include "robot_calls.hpp"

#include <cstdio>
#include <cstring>
#include <memory>

#include <fmt/format.h>
#include <pthread.h>
#include <signal.h>

#include "crash_handler.hpp"
#include "exit_handlers.hpp"
#include "flow.hpp"
#include "robot.hpp"
#include "session.hpp"
#include "signals.hpp"

namespace eyebridge::robios {
namespace {

Strands* strands = nullptr;  // For functions that the C library's callers call.

Time deadline_of(long long nanoseconds) {
  return nanoseconds < 0 ? Lockstep::kNever : Time(nanoseconds);
}

int turns() {
  if (Session::here() == nullptr) return EYEBRIDGE_NO_TURNS;
  if (flow.calls == 0) return EYEBRIDGE_IN_PROGRAM;
  return strands->any() ? EYEBRIDGE_IN_LIBRARY : EYEBRIDGE_NO_TURNS;
}

int at_exit(int how, void* function, void* argument, const void* address) {
  if (Robot::current() == nullptr) return 0;
  using Kind = ExitHandlers::Kind;
  const Kind kind = how == EYEBRIDGE_WITH_STATUS  ? Kind::ExitWithStatus
                    : how == EYEBRIDGE_QUICK_EXIT ? Kind::QuickExit
                                                  : Kind::Exit;
  return ExitHandlers::add(kind, function, argument, address) ? 1 : 0;
}

int raise_in_program(int signal) {
  if (signal < 1 || signal >= NSIG) return 0;
  Robot& robot = *Robot::current();
  if (robot.signals().raise(signal)) return 1;
  if (ProgramSignals::is_harmless(signal)) return 0;
  robot.fail(
      fmt::format("the program was ended by a signal: {}; the others go on", sigdescr_np(signal)),
      128 + signal);
}

/// Before fork(): what other threads have locked stays locked in the child, and it would write,
/// too, what robots have printed.
void hold_shared() {
  ExitHandlers::hold();
  flockfile(stdout);
  std::fflush(stdout);
}
void release_shared() {
  funlockfile(stdout);
  ExitHandlers::release();
}

/// In the child of fork(): the run, and its robots, are the parent's.
void leave_run() {
  ExitHandlers::release();  // the C library has made new locks for its streams
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) ::signal(signal, SIG_DFL);
  leave_signals_alone();
  if (Session* const session = Session::here()) session->note_fork();
}

// In real time.

/// What a new thread is given.
struct Beginning {
  Session* session;
  bool is_programs;  ///< Not of a library.
};

thread_local bool is_created = false;  // not a robot's main thread

/// Of a program's thread, to its end.
struct ProgramThread {
  ProgramThread() = default;
  ProgramThread(const ProgramThread&) = delete;
  ProgramThread& operator=(const ProgramThread&) = delete;
  ~ProgramThread() { Robot::current()->drop_thread(); }
};

void* expect_thread() {
  Session* const session = Session::here();
  if (session == nullptr) return nullptr;
  const bool is_programs = flow.calls == 0;
  if (is_programs) Robot::current()->add_thread();
  return new Beginning{session, is_programs};
}

long long now() { return Session::here()->clock().now() / std::chrono::nanoseconds(1); }

}  // namespace

eyebridge_robot_calls robot_calls(Strands* given) {
  strands = given;
  eyebridge_robot_calls calls{};
  pthread_atfork(hold_shared, release_shared, leave_run);
  calls.leave = [](int code, int how) {
    if (Robot* const robot = Robot::current()) robot->exit(code, how);
  };
  calls.is_program = [](const void* address) {
    const Robot* const robot = Robot::current();
    return robot != nullptr && robot->runs(address) ? 1 : 0;
  };
  calls.state = [](unsigned long size) -> void* {
    Robot* const robot = Robot::current();
    return robot != nullptr ? robot->state(size) : nullptr;
  };
  calls.at_exit = at_exit;
  calls.set_signal = [](int signal, const struct sigaction* action, struct sigaction* before) {
    return Robot::current()->signals().set(signal, action, before) ? 1 : 0;
  };
  calls.raise = raise_in_program;
  calls.abort = [] {
    Robot* const robot = Robot::current();
    if (robot != nullptr && flow.calls == 0) {
      robot->fail("the program called abort(); it ends, the others go on", 134);
    }
  };
  if (given == nullptr) {
    calls.robot = expect_thread;
    calls.begin_thread = [](void* thread) {
      static thread_local const CrashStack stack;
      const std::unique_ptr<Beginning> beginning(static_cast<Beginning*>(thread));
      Session::set_here(beginning->session);
      is_created = true;
      if (beginning->is_programs) static thread_local const ProgramThread counted;
    };
    calls.forget_thread = [](void* thread) {
      const std::unique_ptr<Beginning> beginning(static_cast<Beginning*>(thread));
      if (beginning->is_programs) Robot::current()->drop_thread();
    };
    calls.finish = [](void* /*result*/) {
      Robot* const robot = Robot::current();
      if (robot == nullptr || is_created) return;
      robot->drop_thread();
      robot->hold_thread();  // its main(), in which nothing may be thrown
    };
    return calls;
  }
  calls.turns = turns;
  calls.now = now;
  calls.read_clock = []() -> long long {
    if (turns() != EYEBRIDGE_IN_PROGRAM) return -1;
    return Session::here()->look_at_clock() / std::chrono::nanoseconds(1);
  };
  calls.create = [](void* (*start)(void*), void* argument) {
    return strands->create(start, argument);
  };
  calls.self = [] { return strands->self(); };
  calls.finish = [](void* result) { strands->finish(result); };
  calls.join = [](unsigned long thread, void** result) { return strands->join(thread, result); };
  calls.detach = [](unsigned long thread) { return strands->detach(thread); };
  calls.cancel = [](unsigned long thread) { return strands->cancel(thread); };
  calls.specific = [](unsigned key) { return strands->specifics().get(key); };
  calls.set_specific = [](unsigned key, const void* value) {
    strands->specifics().set(key, value);
  };
  calls.make_key = [](unsigned key, void (*destroy)(void*)) {
    strands->specifics().make(key, destroy);
  };
  calls.forget_key = [](unsigned key) { strands->specifics().forget(key); };
  calls.make_barrier = [](const void* barrier, unsigned count) {
    strands->make_barrier(barrier, count);
  };
  calls.meet = [](const void* barrier) { return strands->meet(barrier) ? 1 : 0; };
  calls.park = [](const void* what, long long deadline) {
    return strands->park(what, deadline_of(deadline)) ? 1 : 0;
  };
  calls.wake = [](const void* what, int all) { strands->wake(what, all != 0); };
  calls.own = [](const void* lock) { return strands->own(lock) ? 1 : 0; };
  calls.disown = [](const void* lock) { return strands->disown(lock); };
  calls.owns = [](const void* lock) { return strands->owns(lock) ? 1 : 0; };
  return calls;
}

}  // namespace eyebridge::robios
