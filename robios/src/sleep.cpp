// libc's sleeping on the robot's clock: a program that waits with usleep() while its motors run
// must see the robot move as far as in real time.

#include <chrono>

#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include "session.hpp"

namespace {

using eyebridge::robios::Session;

/// True when the robot's clock did the waiting.
bool waited(std::chrono::nanoseconds duration) {
  Session* session = Session::with_own_time();
  if (session == nullptr) return false;
  session->wait_until(session->clock().now() + duration);
  return true;
}

bool is_valid(const timespec& time) {
  return time.tv_sec >= 0 && time.tv_nsec >= 0 && time.tv_nsec < 1'000'000'000;
}

}  // namespace

extern "C" {

int nanosleep(const timespec* wanted, timespec* left) {
  if (wanted != nullptr && is_valid(*wanted) &&
      waited(std::chrono::seconds(wanted->tv_sec) + std::chrono::nanoseconds(wanted->tv_nsec))) {
    if (left != nullptr) *left = {};
    return 0;
  }
  return static_cast<int>(syscall(SYS_nanosleep, wanted, left));
}

unsigned sleep(unsigned seconds) {
  const timespec wanted{static_cast<time_t>(seconds), 0};
  timespec left{};
  return nanosleep(&wanted, &left) == 0 ? 0 : static_cast<unsigned>(left.tv_sec);
}

int usleep(useconds_t microseconds) {
  const timespec wanted{static_cast<time_t>(microseconds / 1'000'000),
                        static_cast<long>(microseconds % 1'000'000) * 1000};
  return nanosleep(&wanted, nullptr);
}

}  // extern "C"
