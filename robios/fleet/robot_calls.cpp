#include "robot_calls.hpp"

#include <cstdio>
#include <cstring>

#include <fmt/format.h>
#include <pthread.h>
#include <signal.h>

#include "exit_handlers.hpp"
#include "flow.hpp"
#include "robot.hpp"
#include "session.hpp"
#include "signals.hpp"

namespace eyebridge::robios {
namespace {

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

}  // namespace

eyebridge_robot_calls robot_calls() {
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
  return calls;
}

}  // namespace eyebridge::robios
