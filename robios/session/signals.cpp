#include "signals.hpp"

#include <array>
#include <atomic>
#include <cerrno>
#include <ctime>
#include <system_error>

#include <semaphore.h>
#include <signal.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "eyebridge/base/deaf_thread.hpp"
#include "host.hpp"
#include "library_threads.hpp"

namespace eyebridge::robios {
namespace {

// A handler may do next to nothing: it leaves the signal's number here and wakes a thread. No pipe:
// programs that become daemons close all descriptors.
std::atomic<int> arrived = 0;
sem_t wake_up;
pid_t owner = 0;

void on_signal(int signal) {
  // A child of fork(), before it could leave_signals_alone(); or the second one, of a person who
  // does not want to wait until results are written.
  if (getpid() != owner || arrived.exchange(signal) != 0) {
    ::signal(signal, SIG_DFL);
    raise(signal);
    return;
  }
  const int saved = errno;
  sem_post(&wake_up);
  errno = saved;
}

constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP};

// What an interpreter had for Ctrl-C before us, and whether it has it now. Both belong to the
// thread that waits, but for the moment before it starts.
bool host_has_handler = false;
struct sigaction host_handler {};
bool handed_over = false;

void take(int signal) {
  struct sigaction ours {};
  ours.sa_handler = on_signal;
  ours.sa_flags = SA_RESTART;
  sigaction(signal, &ours, nullptr);
}

/// Lets the interpreter's handler have a Ctrl-C, where it expects it: in the main thread, where it
/// ends what the system lets it wait for.
void hand_over() {
  handed_over = true;
  sigaction(SIGINT, &host_handler, nullptr);
  arrived = 0;
  syscall(SYS_tgkill, getpid(), getpid(), SIGINT);
}

/// The next one is asked about again, unless the program has another handler by then.
void take_back() {
  if (!handed_over) return;
  handed_over = false;
  struct sigaction present {};
  sigaction(SIGINT, nullptr, &present);
  // Not once it has ended: then it may be about to let the signal end the process itself.
  if (host_takes_interrupts() && present.sa_handler == host_handler.sa_handler) take(SIGINT);
}

constexpr long kLookPeriod_ns = 100'000'000;

/// A main thread that left by pthread_exit() takes no signals, and libraries' threads block them.
void take_signals_without_main() {
  if (!main_thread_has_left()) return;
  sigset_t ours;
  sigemptyset(&ours);
  for (const int signal : kSignals) sigaddset(&ours, signal);
  pthread_sigmask(SIG_UNBLOCK, &ours, nullptr);
}

/// False when the look period passed without a signal.
bool woken() {
  timespec until{};
  clock_gettime(CLOCK_MONOTONIC, &until);
  until.tv_nsec += kLookPeriod_ns;
  until.tv_sec += until.tv_nsec / 1'000'000'000;
  until.tv_nsec %= 1'000'000'000;
  while (sem_clockwait(&wake_up, CLOCK_MONOTONIC, &until) != 0) {
    if (errno != EINTR) return false;
  }
  return true;
}

void wait_for_signal(void (*stop)(int), void (*look)()) {
  pthread_setname_np(pthread_self(), "eb:signals");
  for (;;) {
    while (!woken()) {
      take_signals_without_main();
      take_back();
      look();
    }
    if (arrived != SIGINT || !host_has_handler || !host_interrupted()) break;
    hand_over();
  }
  const int signal = arrived;
  stop(signal);
  ::signal(signal, SIG_DFL);
  kill(getpid(), signal);
}

}  // namespace

void watch_signals(void (*stop)(int signal), void (*look)()) {
  owner = getpid();
  sem_init(&wake_up, 0, 0);
  sigaction(SIGINT, nullptr, &host_handler);
  host_has_handler = host_takes_interrupts() && host_handler.sa_handler != SIG_DFL &&
                     host_handler.sa_handler != SIG_IGN;
  deaf_thread([stop, look] { wait_for_signal(stop, look); }).detach();

  for (const int signal : kSignals) {
    struct sigaction present {};
    sigaction(signal, nullptr, &present);
    if (present.sa_handler == SIG_DFL || (signal == SIGINT && host_has_handler)) take(signal);
  }
}

void leave_signals_alone() {
  for (const int signal : kSignals) {
    struct sigaction present {};
    sigaction(signal, nullptr, &present);
    if (present.sa_handler == on_signal) ::signal(signal, SIG_DFL);
  }
}

}  // namespace eyebridge::robios
