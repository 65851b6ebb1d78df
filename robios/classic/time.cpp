// Time and timers.

#include <algorithm>
#include <array>
#include <ctime>
#include <mutex>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "call.hpp"
#include "classic_lcd.hpp"
#include "eyebot.h"
#include "timer_slots.hpp"
#include "timers.hpp"

namespace {

using namespace eyebridge;
using robios::Session;
using robios::classic::call;
using robios::classic::kTick;

constexpr long long kSecond = 100;  // ticks
constexpr long long kMinute = 60 * kSecond;
constexpr long long kHour = 60 * kMinute;
constexpr long long kDay = 24 * kHour;
constexpr std::size_t kMostTimers = 16;

struct Date {
  int day = 1;
  int month = 1;
  int year = 2000;
};

struct Times {
  std::mutex mutex;
  std::optional<long long> midnight;  ///< In ticks of the robot's clock.
  Date today;
  std::set<int> timers;  ///< Those attached.
};

long long ticks_since_start(Session& session) { return session.clock().now() / kTick; }

/// A virtual clock starts at midnight, so that runs repeat.
long long ticks_of_day(Session& session) {
  auto& times = session.own<Times>();
  const std::lock_guard lock(times.mutex);
  const long long now = ticks_since_start(session);
  if (!times.midnight) {
    times.midnight = 0;
    if (!session.clock().is_virtual()) {
      const std::time_t time = std::time(nullptr);
      std::tm local{};
      localtime_r(&time, &local);
      times.midnight =
          now - (local.tm_hour * kHour + local.tm_min * kMinute + local.tm_sec * kSecond);
    }
  }
  return ((now - *times.midnight) % kDay + kDay) % kDay;
}

void store(int* out, long long value) {
  if (out != nullptr) *out = static_cast<int>(value);
}

int wait(const robios::Call& name, Time duration) {
  return call(name, 1, [&](Session& session) -> Result<int> {
    if (duration > Time(0)) robios::classic::wait_until(session.clock().now() + duration);
    return 0;
  });
}

int sleep(const robios::Call& name, Time duration) {
  if (!robios::classic::kernel().started()) return wait(name, duration);
  return robios::classic::doing(name, 1, [&](Session& session) {
    return robios::classic::kernel().sleep_until(session.clock().now() +
                                                 std::max(duration, Time(0)));
  });
}

bool exists(const Date& d) {
  if (d.year < 1 || d.month < 1 || d.month > 12 || d.day < 1) return false;
  static constexpr std::array kDays = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  const bool leap = d.year % 4 == 0 && (d.year % 100 != 0 || d.year % 400 == 0);
  const int days = kDays.at(static_cast<std::size_t>(d.month - 1));
  return d.day <= days + (d.month == 2 && leap ? 1 : 0);
}

}  // namespace

bool eyebridge::robios::classic::timers_attached(Session& session) {
  auto& times = session.own<Times>();
  const std::lock_guard lock(times.mutex);
  return !times.timers.empty();
}

int OSSetTime(int hrs, int mins, int secs) {
  return call("OSSetTime", 1, [&](Session& session) -> Result<int> {
    if (hrs < 0 || hrs > 23 || mins < 0 || mins > 59 || secs < 0 || secs > 59) {
      return fail(Errc::OutOfRange, fmt::format("{}:{}:{} is no time of day", hrs, mins, secs));
    }
    auto& times = session.own<Times>();
    const std::lock_guard lock(times.mutex);
    times.midnight = ticks_since_start(session) - (hrs * kHour + mins * kMinute + secs * kSecond);
    return 0;
  });
}

int OSGetTime(int* hrs, int* mins, int* secs, int* ticks) {
  return call("OSGetTime", 1, [&](Session& session) -> Result<int> {
    const long long now = ticks_of_day(session);
    store(hrs, now / kHour);
    store(mins, now / kMinute % 60);
    store(secs, now / kSecond % 60);
    store(ticks, now % kSecond);
    return 0;
  });
}

int OSShowTime(void) {
  return call("OSShowTime", 1, [](Session& session) -> Result<int> {
    const long long now = ticks_of_day(session);
    robios::classic::lcd(session).print(
        fmt::format("{:02}:{:02}:{:02}", now / kHour, now / kMinute % 60, now / kSecond % 60));
    return 0;
  });
}

int OSSetDate(int day, int month, int year) {
  return call("OSSetDate", 1, [&](Session& session) -> Result<int> {
    if (!exists({day, month, year})) {
      return fail(Errc::OutOfRange, fmt::format("{}.{}.{} is no date", day, month, year));
    }
    auto& times = session.own<Times>();
    const std::lock_guard lock(times.mutex);
    times.today = {day, month, year};
    return 0;
  });
}

int OSGetDate(int* day, int* month, int* year) {
  return call("OSGetDate", 1, [&](Session& session) -> Result<int> {
    auto& times = session.own<Times>();
    const std::lock_guard lock(times.mutex);
    store(day, times.today.day);
    store(month, times.today.month);
    store(year, times.today.year);
    return 0;
  });
}

int OSGetCount(void) {
  return call("OSGetCount", 0, [](Session& session) -> Result<int> {
    return static_cast<int>(static_cast<unsigned>(ticks_since_start(session)));
  });
}

int OSWait(int n) { return wait("OSWait", n * kTick); }
int OSSleep(int n) { return sleep("OSSleep", n * kTick); }
void OSSleepms(int n) { sleep("OSSleepms", std::chrono::milliseconds(n)); }

TimerHandle OSAttachTimer(int scale, TimerFnc function) {
  return call("OSAttachTimer", 0, [&](Session& session) -> Result<int> {
    if (scale < 1 || function == nullptr) {
      return fail(Errc::OutOfRange,
                  fmt::format("a timer needs a function and at least 1 tick, found {}", scale));
    }
    auto& times = session.own<Times>();
    const std::lock_guard lock(times.mutex);
    if (times.timers.size() >= kMostTimers) {
      return fail(Errc::OutOfRange, fmt::format("{} timers are attached already", kMostTimers));
    }
    const int handle = session.timers().attach(scale * kTick, session.bound(function));
    times.timers.insert(handle);
    return handle;
  });
}

int OSDetachTimer(TimerHandle handle) {
  return call("OSDetachTimer", 0, [&](Session& session) -> Result<int> {
    auto& times = session.own<Times>();
    const std::lock_guard lock(times.mutex);
    if (times.timers.erase(handle) == 0 || !session.timers().detach(handle)) {
      return fail(Errc::OutOfRange, fmt::format("there is no timer {}", handle));
    }
    return 1;
  });
}
