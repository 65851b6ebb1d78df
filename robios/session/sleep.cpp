// libc's sleeping on the robot's clock: a program that waits with usleep() while its motors run
// must see the robot move as far as in real time. Libraries, and threads of theirs, sleep as ever.

#include "sleep.hpp"

#include <algorithm>
#include <chrono>

#include <time.h>
#include <unistd.h>

#include "flow.hpp"
#include "program_threads.h"
#include "robot_time.h"
#include "session.hpp"

namespace {

using eyebridge::Time;
using eyebridge::robios::duration_of;
using eyebridge::robios::flow;
using eyebridge::robios::InCall;
using eyebridge::robios::next_of;
using eyebridge::robios::Session;
using eyebridge::robios::sleepers_session;
using eyebridge::robios::take_looks;

/// True when the robot's clock did the waiting.
bool waited(std::chrono::nanoseconds duration) {
  Session* session = sleepers_session();
  if (session == nullptr) return false;
  const InCall in_call;
  session->wait_until(session->clock().now() + take_looks() + duration);
  return true;
}

bool is_valid(const timespec& time) {
  return time.tv_sec >= 0 && time.tv_nsec >= 0 && time.tv_nsec < 1'000'000'000;
}

}  // namespace

namespace eyebridge::robios {

Session* sleepers_session() {
  // In real time timers' functions run in a thread of ours.
  const bool is_timers = flow.in_timer && flow.calls == 0;
  if (flow.session == nullptr && !is_timers && eyebridge_is_in_program() == 0) return nullptr;
  eyebridge_begin_time();
  return Session::with_own_time();
}

Time duration_of(const timespec& time) {
  const auto seconds = std::min<long long>(time.tv_sec, MOST_SECONDS);
  return std::chrono::seconds(seconds) + std::chrono::nanoseconds(time.tv_nsec);
}

}  // namespace eyebridge::robios

extern "C" {

int nanosleep(const timespec* wanted, timespec* left) {
  if (wanted != nullptr && is_valid(*wanted) && waited(duration_of(*wanted))) {
    if (left != nullptr) *left = {};
    return 0;
  }
  static auto* const real = next_of<int(const timespec*, timespec*)>("nanosleep");
  return real(wanted, left);  // as a cancellation point
}

unsigned sleep(unsigned seconds) {
  const timespec wanted{static_cast<time_t>(seconds), 0};
  timespec left{};
  return nanosleep(&wanted, &left) == 0 ? 0 : static_cast<unsigned>(left.tv_sec);
}

int clock_nanosleep(clockid_t clock, int flags, const timespec* wanted, timespec* left) {
  // A moment: for programs in virtual time, whose clock it is on. (With a factor it is not.)
  Session* const session = (flags & TIMER_ABSTIME) != 0 ? sleepers_session() : nullptr;
  if (session != nullptr && session->clock().is_virtual() && is_valid(*wanted)) {
    const InCall in_call;
    const long long until = deadline_of(clock, wanted);
    session->wait_until(Time(until >= 0 ? until : MOST_SECONDS * NANOSECONDS));
    return 0;
  }
  if (flags == 0 && wanted != nullptr && is_valid(*wanted) && sleepers_session() != nullptr) {
    nanosleep(wanted, left);
    return 0;
  }
  static auto* const real =
      next_of<int(clockid_t, int, const timespec*, timespec*)>("clock_nanosleep");
  return real(clock, flags, wanted, left);
}

int usleep(useconds_t microseconds) {
  const timespec wanted{static_cast<time_t>(microseconds / 1'000'000),
                        static_cast<long>(microseconds % 1'000'000) * 1000};
  return nanosleep(&wanted, nullptr);
}

}  // extern "C"
