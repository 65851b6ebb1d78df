#include "signals.hpp"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include "library_threads.hpp"

namespace eyebridge::robios {
namespace {

// A handler may do next to nothing: it writes the signal's number into this pipe, a thread reads
// it.
int wake_up[2] = {-1, -1};
pid_t owner = 0;

void on_signal(int signal) {
  if (getpid() != owner) {  // a child of fork(), before it could leave_signals_alone()
    ::signal(signal, SIG_DFL);
    raise(signal);
    return;
  }
  const int saved = errno;
  const auto number = static_cast<unsigned char>(signal);
  [[maybe_unused]] const ssize_t written = write(wake_up[1], &number, 1);
  errno = saved;
}

constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP};
constexpr int kLookPeriod_ms = 100;

/// A main thread that left by pthread_exit() takes no signals, and libraries' threads block them.
void take_signals_without_main() {
  if (!main_thread_has_left()) return;
  sigset_t ours;
  sigemptyset(&ours);
  for (const int signal : kSignals) sigaddset(&ours, signal);
  pthread_sigmask(SIG_UNBLOCK, &ours, nullptr);
}

void wait_for_signal(void (*stop)(int), void (*look)()) {
  pthread_setname_np(pthread_self(), "eb:signals");
  pollfd pipe{wake_up[0], POLLIN, 0};
  while (poll(&pipe, 1, kLookPeriod_ms) <= 0) {
    take_signals_without_main();
    look();
  }
  unsigned char number = 0;
  if (read(wake_up[0], &number, 1) != 1) return;
  stop(number);
  ::signal(number, SIG_DFL);
  kill(getpid(), number);
}

}  // namespace

void watch_signals(void (*stop)(int signal), void (*look)()) {
  owner = getpid();
  if (pipe2(wake_up, O_CLOEXEC) != 0) {
    throw std::system_error(errno, std::generic_category(), "pipe for signals");
  }
  // The thread itself takes no signal: handlers of the program run on the program's threads.
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  std::thread(wait_for_signal, stop, look).detach();
  pthread_sigmask(SIG_SETMASK, &before, nullptr);

  for (const int signal : kSignals) {
    struct sigaction present {};
    sigaction(signal, nullptr, &present);
    if (present.sa_handler != SIG_DFL) continue;
    struct sigaction ours {};
    ours.sa_handler = on_signal;
    ours.sa_flags = SA_RESTART;
    sigaction(signal, &ours, nullptr);
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
