#include "eyebot.h"
#include "guarded.hpp"
#include "keys.hpp"
#include "program_threads.hpp"

namespace {

using namespace eyebridge;
using robios::Session;

constexpr Time kRemotePoll = std::chrono::milliseconds(10);

/// What the panel has, then what the robot's own receiver has.
Result<int> read_code(Session& session) {
  const int code = session.keys().read_remote();
  hal::Remote* remote = session.backend().remote();
  if (code != 0 || remote == nullptr) return code;
  return remote->read();
}

/// The robot's receiver has to be asked again and again.
Result<int> poll_code(Session& session) {
  for (;;) {
    Result<int> code = read_code(session);
    if (!code || *code != 0 || !session.may_call("IRTVGet")) return code;
    session.wait_until(session.clock().now() + kRemotePoll);
  }
}

}  // namespace

int IRTVGet(void) {
  return robios::guarded("IRTVGet", 0, [](Session& session) -> Result<int> {
    if (session.backend().remote() != nullptr) return poll_code(session);
    Result<int> code = robios::while_away(
        [&] { return session.keys().wait_remote([&](Time until) { session.wait_until(until); }); });
    if (!code && code.error().code == Errc::Unsupported) session.abort_run(code.error());
    return code;
  });
}

int IRTVRead(void) { return robios::guarded("IRTVRead", 0, read_code); }

int IRTVFlush(void) {
  return robios::guarded("IRTVFlush", 1, [](Session& session) -> Result<int> {
    session.keys().flush_remote();
    hal::Remote* remote = session.backend().remote();
    if (remote == nullptr) return 0;
    return remote->read().map([](int) { return 0; });
  });
}

int IRTVGetStatus(void) {
  return robios::guarded("IRTVGetStatus", 0, [](Session&) -> Result<int> { return 1; });
}
