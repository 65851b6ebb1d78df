// libc's sleeping on the robot's clock: a program that waits with usleep() while its motors run
// must see the robot move as far as in real time. Libraries, and threads of theirs, sleep as ever.

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>

#include <dlfcn.h>
#include <poll.h>
#include <sys/select.h>
#include <time.h>
#include <unistd.h>

#include "flow.hpp"
#include "program_threads.h"
#include "robot_time.h"
#include "session.hpp"

namespace {

using eyebridge::Time;
using eyebridge::robios::flow;
using eyebridge::robios::InCall;
using eyebridge::robios::Session;
using eyebridge::robios::take_looks;

/// The session of the calling program, when its clock is not the wall clock; else null.
Session* own_time() {
  // In real time timers' functions run in a thread of ours.
  const bool is_timers = flow.in_timer && flow.calls == 0;
  if (flow.session == nullptr && !is_timers && eyebridge_is_in_program() == 0) return nullptr;
  eyebridge_begin_time();
  return Session::with_own_time();
}

/// True when the robot's clock did the waiting.
bool waited(std::chrono::nanoseconds duration) {
  Session* session = own_time();
  if (session == nullptr) return false;
  const InCall in_call;
  session->wait_until(session->clock().now() + take_looks() + duration);
  return true;
}

/// The C library's own.
template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

/// In virtual time: looks again and again for `patience` of the robot's time, until it sees
/// something; nothing for others, who wait as ever.
template <class Look>
std::optional<int> watched(Time patience, Look look) {
  constexpr Time kPause = std::chrono::milliseconds(1);
  std::optional<Time> deadline;
  for (Session* session = own_time(); session != nullptr && session->clock().is_virtual();
       session = own_time()) {
    const int seen = look();
    const Time now = session->clock().now();
    if (!deadline) deadline = now + take_looks() + patience;
    if (seen != 0 || now >= *deadline) return seen;
    const InCall in_call;
    session->wait_until(std::min(*deadline, now + kPause));
  }
  return std::nullopt;
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
  static auto* const real = next<int(const timespec*, timespec*)>("nanosleep");
  return real(wanted, left);  // as a cancellation point
}

unsigned sleep(unsigned seconds) {
  const timespec wanted{static_cast<time_t>(seconds), 0};
  timespec left{};
  return nanosleep(&wanted, &left) == 0 ? 0 : static_cast<unsigned>(left.tv_sec);
}

int clock_nanosleep(clockid_t clock, int flags, const timespec* wanted, timespec* left) {
  // A moment: for programs in virtual time, whose clock it is on. (With a factor it is not.)
  Session* const session = (flags & TIMER_ABSTIME) != 0 ? own_time() : nullptr;
  if (session != nullptr && session->clock().is_virtual() && is_valid(*wanted)) {
    const InCall in_call;
    session->wait_until(eyebridge::Time(deadline_of(clock, wanted)));
    return 0;
  }
  if (flags == 0 && wanted != nullptr && is_valid(*wanted) && own_time() != nullptr) {
    nanosleep(wanted, left);
    return 0;
  }
  static auto* const real =
      next<int(clockid_t, int, const timespec*, timespec*)>("clock_nanosleep");
  return real(clock, flags, wanted, left);
}

int usleep(useconds_t microseconds) {
  const timespec wanted{static_cast<time_t>(microseconds / 1'000'000),
                        static_cast<long>(microseconds % 1'000'000) * 1000};
  return nanosleep(&wanted, nullptr);
}

int select(int count, fd_set* to_read, fd_set* to_write, fd_set* to_except, timeval* most) {
  using Select = int(int, fd_set*, fd_set*, fd_set*, timeval*);
  if (most == nullptr || most->tv_sec < 0 || most->tv_usec < 0) {
    return next<Select>("select")(count, to_read, to_write, to_except, most);
  }
  std::array<fd_set*, 3> sets{to_read, to_write, to_except};
  std::array<fd_set, 3> wanted{};
  for (std::size_t i = 0; i < sets.size(); ++i) {
    if (sets[i] != nullptr) wanted[i] = *sets[i];
  }
  const auto look = [&] {
    for (std::size_t i = 0; i < sets.size(); ++i) {
      if (sets[i] != nullptr) *sets[i] = wanted[i];
    }
    timeval at_once{};
    return next<Select>("select")(count, to_read, to_write, to_except, &at_once);
  };
  const Time patience =
      std::chrono::seconds(most->tv_sec) + std::chrono::microseconds(most->tv_usec);
  if (const std::optional<int> seen = watched(patience, look)) {
    if (*seen == 0) *most = {};
    return *seen;
  }
  return next<Select>("select")(count, to_read, to_write, to_except, most);
}

int poll(pollfd* files, nfds_t count, int most_ms) {
  using Poll = int(pollfd*, nfds_t, int);
  const auto look = [&] { return next<Poll>("poll")(files, count, 0); };
  if (most_ms > 0) {
    const std::optional<int> seen = watched(std::chrono::milliseconds(most_ms), look);
    if (seen) return *seen;
  }
  return next<Poll>("poll")(files, count, most_ms);
}

}  // extern "C"
