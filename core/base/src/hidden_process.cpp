#include "eyebridge/base/hidden_process.hpp"

#include <cerrno>
#include <csignal>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace eyebridge {
namespace {

void keep_only(std::span<const int> keep) {
  // First out of each other's way: one of them may have the number that another one is to get.
  const int count = static_cast<int>(keep.size());
  const int first = count + 1;
  int copied = 0;
  for (const int descriptor : keep) {
    const int copy = fcntl(descriptor, F_DUPFD, first);
    dup2(copy, copied++);
  }
  if (syscall(SYS_close_range, static_cast<unsigned>(count), ~0U, 0U) == 0) return;
  for (int descriptor = count; descriptor < 1024; ++descriptor) close(descriptor);
}

}  // namespace

bool start_hidden_process(const char* name, std::span<const int> keep,
                          void (*body)(const void* argument), const void* argument) noexcept {
  // The copy has the program's handlers and process group at first: a Ctrl-Z that came then would
  // stop it for good.
  sigset_t all;
  sigset_t own;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &own);
  // A fork() without the handlers of fork() and without a signal when it ends, so that neither the
  // program nor its wait() notices.
  const long child = syscall(SYS_clone, 0L, 0L, 0L, 0L, 0L);
  if (child == 0) {
    setsid();
    prctl(PR_SET_NAME, name);
    keep_only(keep);
    body(argument);
    _exit(0);
  }
  const int error = errno;
  pthread_sigmask(SIG_SETMASK, &own, nullptr);
  errno = error;
  return child > 0;
}

}  // namespace eyebridge
