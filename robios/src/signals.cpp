#include "signals.hpp"

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

void on_signal(int signal) {
  const int saved = errno;
  const auto number = static_cast<unsigned char>(signal);
  [[maybe_unused]] const ssize_t written = write(wake_up[1], &number, 1);
  errno = saved;
}

// How long a process lives on after its last thread but ours.
constexpr int kLookPeriod_ms = 100;

void wait_for_signal(void (*stop)(int)) {
  pthread_setname_np(pthread_self(), "eb:signals");
  pollfd pipe{wake_up[0], POLLIN, 0};
  while (poll(&pipe, 1, kLookPeriod_ms) <= 0) {
    if (only_library_threads_left()) std::exit(0);
  }
  unsigned char number = 0;
  if (read(wake_up[0], &number, 1) != 1) return;
  stop(number);
  ::signal(number, SIG_DFL);
  kill(getpid(), number);
}

}  // namespace

void watch_signals(void (*stop)(int signal)) {
  if (pipe2(wake_up, O_CLOEXEC) != 0) {
    throw std::system_error(errno, std::generic_category(), "pipe for signals");
  }
  // The thread itself takes no signal: handlers of the program run on the program's threads.
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  std::thread(wait_for_signal, stop).detach();
  pthread_sigmask(SIG_SETMASK, &before, nullptr);

  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction present {};
    sigaction(signal, nullptr, &present);
    if (present.sa_handler != SIG_DFL) continue;
    struct sigaction ours {};
    ours.sa_handler = on_signal;
    ours.sa_flags = SA_RESTART;
    sigaction(signal, &ours, nullptr);
  }
}

}  // namespace eyebridge::robios
