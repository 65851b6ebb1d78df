#include "call.hpp"
#include "eyebot.h"
#include "keys.hpp"
#include "keys_wait.hpp"
#include "program_threads.hpp"

namespace {

using namespace eyebridge;
using robios::Session;
using robios::classic::call;
using robios::classic::doing;

constexpr int kAnyKey = KEY1 | KEY2 | KEY3 | KEY4;

/// A program that waits for what can never come would wait for ever: it ends instead.
template <class Value>
Result<Value> or_end_waiting(Session& session, Result<Value> waited) {
  if (!waited && waited.error().code == Errc::Unsupported) session.abort_run(waited.error());
  return waited;
}

int wait_for(const robios::Call& name, int mask) {
  return call(name, NOKEY,
              [&](Session& session) { return robios::classic::wait_for_key(session, mask); });
}

}  // namespace

Result<int> eyebridge::robios::classic::wait_for_key(Session& session, int mask) {
  return or_end_waiting(session,
                        while_away([&] { return session.keys().wait(mask, classic::wait_until); }));
}

int KEYGetBuf(char* buf) {
  return doing("KEYGetBuf", 1, [&](Session& session) -> Result<void> {
    if (buf == nullptr) return robios::null_pointer();
    return robios::classic::wait_for_key(session, kAnyKey).map([&](int key) {
      *buf = static_cast<char>(key);
    });
  });
}

int KEYGet(void) { return wait_for("KEYGet", kAnyKey); }
int KEYWait(int excode) { return wait_for("KEYWait", excode); }

int KEYRead(void) {
  return call("KEYRead", NOKEY,
              [](Session& session) -> Result<int> { return session.keys().read(); });
}

int KEYGetXY(int* x, int* y) {
  return doing("KEYGetXY", 1, [&](Session& session) -> Result<void> {
    if (x == nullptr || y == nullptr) return robios::null_pointer();
    const auto touch =
        robios::while_away([&] { return session.keys().wait_touch(robios::classic::wait_until); });
    return or_end_waiting(session, touch).map([&](robios::TouchPoint point) {
      *x = point.x;
      *y = point.y;
    });
  });
}
