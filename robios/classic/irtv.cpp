#include <deque>
#include <mutex>

#include <fmt/format.h>

#include "call.hpp"
#include "eyebot.h"
#include "keys.hpp"
#include "lookup.hpp"
#include "program_threads.hpp"

namespace {

using namespace eyebridge;
using robios::Session;
using robios::classic::call;
using robios::classic::doing;

// In virtual time an hour passes in no time.
constexpr Time kLongestWait = std::chrono::hours(1);
constexpr int kNoEntry = 2;

struct RemoteControl {
  std::mutex mutex;
  bool listening = false;
  std::deque<int> codes;
};

/// Takes the codes that have come: from a receiver on the robot, and the script or window of the
/// keys. Lock the remote control.
Result<void> listen(Session& session, RemoteControl& control) {
  if (!control.listening) {
    return fail(Errc::Unsupported, "the remote control is not initialised: call IRTVInit first");
  }
  while (const int code = session.keys().read_remote()) control.codes.push_back(code);
  hal::Remote* const remote = session.backend().remote();
  while (remote != nullptr) {
    const Result<int> code = remote->read();
    if (!code) return tl::unexpected(code.error());
    if (*code == 0) return {};
    control.codes.push_back(*code);
  }
  return {};
}

Result<int> next_code(Session& session, bool take) {
  auto& control = session.own<RemoteControl>();
  const std::lock_guard lock(control.mutex);
  return listen(session, control).map([&] {
    if (control.codes.empty()) return 0;
    const int code = control.codes.front();
    if (take) control.codes.pop_front();
    return code;
  });
}

/// Ends the program when no code can come any more.
Result<int> wait_for_code(Session& session) {
  Result<int> code =
      robios::while_away([&] { return session.keys().wait_remote(robios::classic::wait_until); });
  if (!code && code.error().code == Errc::Unsupported) session.abort_run(code.error());
  return code;
}

int begin(const robios::Call& name, int failure, bool legal, const char* what) {
  return doing(name, failure, [&](Session& session) -> Result<void> {
    if (!legal) return fail(Errc::OutOfRange, what);
    auto& control = session.own<RemoteControl>();
    const std::lock_guard lock(control.mutex);
    control.listening = true;
    control.codes.clear();
    return {};
  });
}

}  // namespace

int IRTVInitHDT(DeviceSemantics semantics) {
  const DeviceSemantics number = robios::classic::number_of(semantics);
  return begin("IRTVInitHDT", kNoEntry, number == IRTV || number == UNKNOWN_SEMANTICS,
               "expected IRTV, the only remote control");
}

int IRTVInit(int type, int, int, int, int mode, int bufsize, int) {
  const bool legal = type >= RAW_CODE && type <= MANCHESTER_CODE && mode >= DEFAULT_MODE &&
                     mode <= REPCODE_MODE && bufsize >= 1 && bufsize <= 4;
  return begin("IRTVInit", 1, legal, "no such type, mode or size of the buffer");
}

void IRTVTerm(void) {
  doing("IRTVTerm", 1, [](Session& session) -> Result<void> {
    auto& control = session.own<RemoteControl>();
    const std::lock_guard lock(control.mutex);
    control.listening = false;
    control.codes.clear();
    return {};
  });
}

int IRTVPressed(void) {
  return call("IRTVPressed", 0, [](Session& session) { return next_code(session, false); });
}

int IRTVRead(void) {
  return call("IRTVRead", 0, [](Session& session) { return next_code(session, true); });
}

int IRTVGet(void) {
  return call("IRTVGet", 0, [](Session& session) -> Result<int> {
    const Time since = session.clock().now();
    while (session.may_call("IRTVGet")) {
      Result<int> code = next_code(session, true);
      if (!code || *code != 0) return code;
      // A robot without a receiver: only the script or a person can send one, maybe much later.
      if (session.backend().remote() == nullptr) return wait_for_code(session);
      if (session.clock().is_virtual() && session.clock().now() - since > kLongestWait) {
        session.abort_run({Errc::Unsupported,
                           "waits for a code of the remote control that can "
                           "never come; --keys \"IRTV_5@2s\" sends one"});
      }
      robios::classic::wait_until(session.clock().now() + robios::classic::kTick);
    }
    return fail(Errc::Timeout, "the run has ended");
  });
}

void IRTVFlush(void) {
  doing("IRTVFlush", 1, [](Session& session) -> Result<void> {
    auto& control = session.own<RemoteControl>();
    const std::lock_guard lock(control.mutex);
    return listen(session, control).map([&] { control.codes.clear(); });
  });
}

void IRTVGetRaw(int bits[2], int* count, int* duration, int* id, int* clock) {
  doing("IRTVGetRaw", 1, [&](Session&) -> Result<void> {
    if (bits != nullptr) bits[0] = bits[1] = 0;
    for (int* out : {count, duration, id, clock}) {
      if (out != nullptr) *out = 0;
    }
    return fail(Errc::Unsupported, "codes come decoded: there are no signals");
  });
}

int IRTVDecodeRaw(const int*, int, int) {
  return call("IRTVDecodeRaw", -1, [](Session&) -> Result<int> {
    return fail(Errc::Unsupported, "codes come decoded: there are no signals");
  });
}
