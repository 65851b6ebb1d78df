#include "guarded.hpp"
#include "keys.hpp"
#include "program_threads.hpp"
#include <eyebot.h>

using eyebridge::Errc;
using eyebridge::Result;
using eyebridge::Time;
using eyebridge::robios::guarded;
using eyebridge::robios::null_pointer;
using eyebridge::robios::Session;
using eyebridge::robios::TouchPoint;
using eyebridge::robios::while_away;

namespace {

constexpr int kKeyFailed = 1;

/// Waiting goes through the session, so that timers run meanwhile.
auto session_wait(Session& session) {
  return [&session](Time deadline) { session.wait_until(deadline); };
}

/// A program that waits for what can never come would wait for ever: it ends instead.
template <class Value>
Result<Value> or_end(Session& session, Result<Value> waited) {
  if (!waited && waited.error().code == Errc::Unsupported) {
    session.abort_run(waited.error());
  }
  return waited;
}

Result<int> wait_for_key(Session& session, int mask) {
  return or_end(session,
                while_away([&] { return session.keys().wait(mask, session_wait(session)); }));
}

}  // namespace

int KEYGet(void) {
  return guarded("KEYGet", NOKEY,
                 [](Session& session) { return wait_for_key(session, KEY1 | KEY2 | KEY3 | KEY4); });
}

int KEYRead(void) {
  return guarded("KEYRead", NOKEY,
                 [](Session& session) -> Result<int> { return session.keys().read(); });
}

int KEYWait(int key) {
  return guarded("KEYWait", NOKEY, [&](Session& session) { return wait_for_key(session, key); });
}

int KEYGetXY(int* x, int* y) {
  return guarded("KEYGetXY", kKeyFailed, [&](Session& session) -> Result<int> {
    if (x == nullptr || y == nullptr) {
      return null_pointer();
    }
    const auto touch = while_away([&] { return session.keys().wait_touch(session_wait(session)); });
    return or_end(session, touch).map([&](TouchPoint point) {
      *x = point.x;
      *y = point.y;
      return 0;
    });
  });
}

int KEYReadXY(int* x, int* y) {
  return guarded("KEYReadXY", kKeyFailed, [&](Session& session) -> Result<int> {
    if (x == nullptr || y == nullptr) {
      return null_pointer();
    }
    const auto point = session.keys().read_touch();
    if (!point) {
      return 1;
    }
    *x = point->x;
    *y = point->y;
    return 0;
  });
}

// In no manual, but in the published library, and old programs call them without a declaration.
extern "C" {
__attribute__((visibility("default"))) int KEYInit(void) { return 0; }
__attribute__((visibility("default"))) int KEYRelease(void) { return 0; }
}
