// libc's waiting for files, for so long at most: on the robot's clock in virtual time, as
// sleep.cpp.

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>

#include <poll.h>
#include <sys/epoll.h>
#include <sys/select.h>

#include "flow.hpp"
#include "session.hpp"
#include "sleep.hpp"

namespace {

using eyebridge::Time;
using eyebridge::robios::duration_of;
using eyebridge::robios::InCall;
using eyebridge::robios::next_of;
using eyebridge::robios::Session;
using eyebridge::robios::sleepers_session;
using eyebridge::robios::take_looks;
using std::chrono::milliseconds;

/// In virtual time: looks again and again for `patience` of the robot's time, until it sees
/// something; nothing for others, who wait as ever.
template <class Look>
std::optional<int> watched(Time patience, Look look) {
  constexpr Time kPause = milliseconds(1);
  std::optional<Time> deadline;
  for (Session* session = sleepers_session(); session != nullptr && session->clock().is_virtual();
       session = sleepers_session()) {
    const int seen = look();
    const Time now = session->clock().now();
    if (!deadline) deadline = now + take_looks() + patience;
    if (seen != 0 || now >= *deadline) return seen;
    const InCall in_call;
    session->wait_until(std::min(*deadline, now + kPause));
  }
  return std::nullopt;
}

/// Sets of files: select() leaves in them what it has seen.
class Sets {
 public:
  Sets(fd_set* to_read, fd_set* to_write, fd_set* to_except) : sets_{to_read, to_write, to_except} {
    for (std::size_t i = 0; i < sets_.size(); ++i) {
      if (sets_[i] != nullptr) wanted_[i] = *sets_[i];
    }
  }
  void restore() {
    for (std::size_t i = 0; i < sets_.size(); ++i) {
      if (sets_[i] != nullptr) *sets_[i] = wanted_[i];
    }
  }

 private:
  const std::array<fd_set*, 3> sets_;
  std::array<fd_set, 3> wanted_{};
};

bool is_wait(const timespec* most) {
  return most != nullptr && most->tv_sec >= 0 && most->tv_nsec >= 0 &&
         most->tv_nsec < 1'000'000'000 && (most->tv_sec > 0 || most->tv_nsec > 0);
}

}  // namespace

extern "C" {

int select(int count, fd_set* to_read, fd_set* to_write, fd_set* to_except, timeval* most) {
  auto* const real = next_of<int(int, fd_set*, fd_set*, fd_set*, timeval*)>("select");
  if (most != nullptr && most->tv_sec >= 0 && most->tv_usec >= 0) {
    Sets sets(to_read, to_write, to_except);
    const auto look = [&] {
      sets.restore();
      timeval at_once{};
      return real(count, to_read, to_write, to_except, &at_once);
    };
    const Time patience = duration_of({most->tv_sec, 0}) + std::chrono::microseconds(most->tv_usec);
    if (const std::optional<int> seen = watched(patience, look)) {
      if (*seen == 0) *most = {};
      return *seen;
    }
  }
  return real(count, to_read, to_write, to_except, most);
}

int pselect(int count, fd_set* to_read, fd_set* to_write, fd_set* to_except, const timespec* most,
            const sigset_t* mask) {
  auto* const real =
      next_of<int(int, fd_set*, fd_set*, fd_set*, const timespec*, const sigset_t*)>("pselect");
  if (is_wait(most)) {
    Sets sets(to_read, to_write, to_except);
    const auto look = [&] {
      sets.restore();
      const timespec at_once{};
      return real(count, to_read, to_write, to_except, &at_once, mask);
    };
    if (const std::optional<int> seen = watched(duration_of(*most), look)) return *seen;
  }
  return real(count, to_read, to_write, to_except, most, mask);
}

int poll(pollfd* files, nfds_t count, int most_ms) {
  auto* const real = next_of<int(pollfd*, nfds_t, int)>("poll");
  if (most_ms > 0) {
    const auto look = [&] { return real(files, count, 0); };
    if (const std::optional<int> seen = watched(milliseconds(most_ms), look)) return *seen;
  }
  return real(files, count, most_ms);
}

int ppoll(pollfd* files, nfds_t count, const timespec* most, const sigset_t* mask) {
  auto* const real = next_of<int(pollfd*, nfds_t, const timespec*, const sigset_t*)>("ppoll");
  if (is_wait(most)) {
    const auto look = [&] {
      const timespec at_once{};
      return real(files, count, &at_once, mask);
    };
    if (const std::optional<int> seen = watched(duration_of(*most), look)) return *seen;
  }
  return real(files, count, most, mask);
}

int epoll_pwait(int file, epoll_event* events, int count, int most_ms, const sigset_t* mask) {
  auto* const real = next_of<int(int, epoll_event*, int, int, const sigset_t*)>("epoll_pwait");
  if (most_ms > 0) {
    const auto look = [&] { return real(file, events, count, 0, mask); };
    if (const std::optional<int> seen = watched(milliseconds(most_ms), look)) return *seen;
  }
  return real(file, events, count, most_ms, mask);
}

int epoll_wait(int file, epoll_event* events, int count, int most_ms) {
  return epoll_pwait(file, events, count, most_ms, nullptr);
}

}  // extern "C"
