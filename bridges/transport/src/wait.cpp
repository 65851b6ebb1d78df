#include "wait.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <thread>

#include <poll.h>

#include "eyebridge/bridges/monotonic_clock.hpp"

namespace eyebridge::bridges {
namespace {

/// One poll; `wait` of 0 only looks.
bool poll_once(int fd, short events, Time wait) {
  pollfd entry{fd, events, 0};
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(wait);
  const timespec limit{static_cast<time_t>(seconds.count()),
                       static_cast<long>((wait - seconds).count())};
  // A signal ends the wait early; the caller asks again for what is left.
  return ::ppoll(&entry, 1, &limit, nullptr) > 0;
}

}  // namespace

void MonotonicClock::wait_until(Time deadline) {
  constexpr Time kLongest = std::chrono::hours(1);  // a deadline of Time::max() would overflow
  for (Time left = deadline - now(); left > Time{0}; left = deadline - now()) {
    std::this_thread::sleep_for(std::min(left, kLongest));
  }
}

bool wait_ready(int fd, short events, Clock& clock, Time deadline) {
  constexpr Time kLongest = std::chrono::hours(1);
  while (true) {
    const Time left = deadline - clock.now();
    if (left <= Time{0}) return poll_once(fd, events, Time{0});
    if (clock.is_virtual()) {
      if (poll_once(fd, events, Time{0})) return true;
      clock.wait_until(deadline);
    } else if (poll_once(fd, events, std::min(left, kLongest))) {
      return true;
    }
  }
}

std::string errno_text(int error) { return std::system_category().message(error); }

}  // namespace eyebridge::bridges
