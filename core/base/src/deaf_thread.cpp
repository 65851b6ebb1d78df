#include "eyebridge/base/deaf_thread.hpp"

#include <utility>

#include <pthread.h>
#include <signal.h>

namespace eyebridge {

std::thread deaf_thread(std::function<void()> body) {
  // A new thread has its maker's mask.
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  std::thread thread(std::move(body));
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return thread;
}

}  // namespace eyebridge
