#include <algorithm>
#include <atomic>
#include <cstring>
#include <ctime>
#include <mutex>
#include <string>

#include <fmt/format.h>

#include "eyebot.h"
#include "guarded.hpp"
#include "timers.hpp"

namespace {

using namespace eyebridge;
using robios::Session;
using std::chrono::milliseconds;

/// The robot's time of day.
struct TimeOfDay {
  std::atomic<long long> set_ahead = 0;  ///< What OSSetTime() has added, milliseconds.
  std::once_flag asked;
  long long first_start = 0;  ///< When a clock that is real time was 0, milliseconds of the day.
};

/// Milliseconds since midnight. A virtual clock starts at midnight, so that runs repeat.
long long milliseconds_of_day(Session& session) {
  const long long since_start = session.clock().now() / milliseconds(1);
  auto& day = session.own<TimeOfDay>();
  if (!session.clock().is_virtual()) {
    std::call_once(day.asked, [&] {
      const std::time_t now = std::time(nullptr);
      std::tm local{};
      localtime_r(&now, &local);
      day.first_start =
          ((local.tm_hour * 60LL + local.tm_min) * 60 + local.tm_sec) * 1000 - since_start;
    });
  }
  constexpr long long kDay = 24LL * 60 * 60 * 1000;
  return ((day.first_start + since_start + day.set_ahead) % kDay + kDay) % kDay;
}

}  // namespace

int OSWait(int n) {
  return robios::guarded("OSWait", 1, [&](Session& session) -> Result<int> {
    if (n > 0) session.wait_until(session.clock().now() + milliseconds(n));
    return 0;
  });
}

TIMER OSAttachTimer(int scale, void (*fct)(void)) {
  return robios::guarded("OSAttachTimer", 0, [&](Session& session) -> Result<int> {
    if (scale <= 0 || fct == nullptr) {
      return fail(Errc::OutOfRange,
                  fmt::format("a timer needs a function and at least 1 ms, found {} ms", scale));
    }
    return session.timers().attach(milliseconds(scale), session.bound(fct));
  });
}

int OSDetachTimer(TIMER t) {
  return robios::guarded("OSDetachTimer", 1, [&](Session& session) -> Result<int> {
    if (session.timers().detach(t)) return 0;
    return fail(Errc::OutOfRange, fmt::format("there is no timer {}", t));
  });
}

int OSGetTime(int* hrs, int* mins, int* secs, int* ticks) {
  return robios::guarded("OSGetTime", 1, [&](Session& session) -> Result<int> {
    const long long ms = milliseconds_of_day(session);
    const auto put = [](int* out, long long value) {
      if (out != nullptr) *out = static_cast<int>(value);
    };
    put(hrs, ms / 3'600'000);
    put(mins, ms / 60'000 % 60);
    put(secs, ms / 1000 % 60);
    put(ticks, ms % 1000);
    return 0;
  });
}

int OSSetTime(int hrs, int mins, int secs) {
  return robios::guarded("OSSetTime", 1, [&](Session& session) -> Result<int> {
    if (hrs < 0 || hrs > 23 || mins < 0 || mins > 59 || secs < 0 || secs > 59) {
      return fail(Errc::OutOfRange, fmt::format("{}:{}:{} is no time of day", hrs, mins, secs));
    }
    session.own<TimeOfDay>().set_ahead +=
        ((hrs * 60LL + mins) * 60 + secs) * 1000 - milliseconds_of_day(session);
    return 0;
  });
}

int OSGetCount(void) {
  return robios::guarded("OSGetCount", 0, [](Session& session) -> Result<int> {
    return static_cast<int>(session.clock().now() / milliseconds(1));
  });
}

int OSVersion(char* buf) {
  return robios::guarded("OSVersion", 1, [&](Session&) -> Result<int> {
    if (buf == nullptr) return robios::null_pointer();
    std::strcpy(buf, VERSION);
    return 0;
  });
}

int OSVersionIO(char* buf) {
  return robios::guarded("OSVersionIO", 1, [&](Session& session) -> Result<int> {
    if (buf == nullptr) return robios::null_pointer();
    buf[0] = '\0';
    hal::IoBoard* board = session.backend().io_board();
    if (board == nullptr) return fail(Errc::NoDevice, "this robot has no I/O board");
    return board->version().map([&](const std::string& version) {
      constexpr std::size_t kLongest = 99;  // programs have 100 bytes for it
      const std::size_t length = std::min(version.size(), kLongest);
      std::memcpy(buf, version.data(), length);
      buf[length] = '\0';
      return 0;
    });
  });
}

int OSMachineSpeed(void) {
  return robios::guarded("OSMachineSpeed", MACHINE_SPEED,
                         [](Session&) -> Result<int> { return MACHINE_SPEED; });
}

int OSMachineType(void) {
  return robios::guarded("OSMachineType", VEHICLE, [](Session&) -> Result<int> { return VEHICLE; });
}

int OSMachineName(char* buf) {
  return robios::guarded("OSMachineName", 1, [&](Session&) -> Result<int> {
    if (buf == nullptr) return robios::null_pointer();
    std::strcpy(buf, MACHINE_NAME);
    return 0;
  });
}

int OSMachineID(void) {
  return robios::guarded("OSMachineID", 0, [](Session& session) -> Result<int> {
    return session.backend().robot_id();
  });
}
