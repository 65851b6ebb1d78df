#include "host.hpp"

#include <chrono>
#include <mutex>
#include <string>
#include <system_error>

#include "eyebridge_host.h"
#include "guarded.hpp"
#include "program_threads.h"
#include "session.hpp"
#include "timers.hpp"

namespace eyebridge::robios {
namespace {

struct Host {
  std::mutex mutex;  ///< Held while one of the functions runs.
  std::string program;
  int (*interrupted)() = nullptr;
  void (*ending)() = nullptr;
};

/// Never destroyed: the thread that waits for signals may still ask while the process ends.
Host& host() {
  static Host* const the_host = new Host;
  return *the_host;
}

/// guarded() for the language's own clock: nothing that other robots wait for as a first call.
template <class Value, class Body>
Value in_time(const Call& call, Value failure, Body body) {
  Session& session = Session::instance();
  if (!session.is_before_first_call() && !session.may_call(call.name)) return failure;
  return carry_out(session, call, failure, body);
}

/// Before the session has begun: will its clock be another than the wall clock?
bool will_have_own_time() {
  static const bool own = [] {
    try {
      const hal::Config config = hal::Config::from_process(program_file());
      return config.boolean("fast") || config.number("factor") != 1.0 ||
             config.text("hal").starts_with("replay:");
    } catch (const ConfigError&) {
      return false;  // the first RoBIOS call reports it
    }
  }();
  return own;
}

/// The session whose clock the program's time is, begun if need be; else null.
bool has_own_time() {
  if (Session::has_begun()) return Session::with_own_time() != nullptr;
  return will_have_own_time();
}

}  // namespace

std::filesystem::path program_file() {
  const std::lock_guard lock(host().mutex);
  std::error_code error;
  return host().program.empty() ? std::filesystem::read_symlink("/proc/self/exe", error)
                                : std::filesystem::path(host().program);
}

bool host_takes_interrupts() {
  const std::lock_guard lock(host().mutex);
  return host().interrupted != nullptr;
}

bool host_interrupted() {
  const std::lock_guard lock(host().mutex);
  return host().interrupted != nullptr && host().interrupted() != 0;
}

void host_ending() {
  const std::lock_guard lock(host().mutex);
  if (host().ending != nullptr) host().ending();
}

}  // namespace eyebridge::robios

using eyebridge::Result;
using eyebridge::Time;
using eyebridge::robios::host;
using eyebridge::robios::in_time;
using eyebridge::robios::Session;

void EYEBRIDGEHostBegin(const char* program, int (*interrupted)(void), void (*ending)(void)) {
  const std::lock_guard lock(host().mutex);
  host().program = program == nullptr ? "" : program;
  host().interrupted = interrupted;
  host().ending = ending;
}

void EYEBRIDGEHostEnd(void) {
  {
    const std::lock_guard lock(host().mutex);
    host().interrupted = nullptr;
    host().ending = nullptr;
  }
  if (!Session::has_begun()) return;
  Session::instance().end();
  Session::instance().timers().finish();
  Session::program_ends(0);
  Session::instance().await_end();
}

void* EYEBRIDGEHostThreadExpected(void) {
  if (!eyebridge::robios::has_own_time()) return nullptr;
  static_cast<void>(Session::instance());
  eyebridge_hold_turn();
  return eyebridge_thread_expected();
}

void EYEBRIDGEHostThreadStarts(void* expected) {
  if (expected != nullptr) eyebridge_thread_starts(expected);
}

void EYEBRIDGEHostThreadFailed(void* expected) {
  if (expected != nullptr) eyebridge_thread_failed(expected);
}

void EYEBRIDGEHostThreadStarted(void* expected) {
  if (expected != nullptr) eyebridge_release_turn();
}

int EYEBRIDGEHostWait(long long nanoseconds) {
  if (!eyebridge::robios::has_own_time()) return 0;
  return in_time("OSWait", 0, [&](Session& session) -> Result<int> {
    session.wait_until(session.clock().now() + Time(nanoseconds));
    return 1;
  });
}

long long EYEBRIDGEHostNow(void) {
  if (!eyebridge::robios::has_own_time()) return -1;
  return in_time("OSGetCount", -1LL, [](Session& session) -> Result<long long> {
    return session.clock().now() / std::chrono::nanoseconds(1);
  });
}
