#include <algorithm>

#include <fmt/format.h>

#include "eyebot.h"
#include "guarded.hpp"
#include "no_device.hpp"

namespace {

using namespace eyebridge;

int set(const robios::Call& call, int id, int angle) {
  return robios::guarded(call, 1, [&](robios::Session& session) -> Result<int> {
    if (angle < 0 || angle > 255) {
      return fail(Errc::OutOfRange, fmt::format("servo position {} is outside 0..255", angle));
    }
    hal::Servo* servo = session.backend().servo(id);
    if (servo == nullptr) return robios::no_device(session, "servo", id);
    // 128 is the middle, 1 and 255 the ends; 0 is one more step, as in EyeSim.
    return servo->set(std::clamp(0.5 + (angle - 128) / 254.0, 0.0, 1.0)).map([] { return 0; });
  });
}

}  // namespace

int SERVOSet(int servo, int angle) { return set("SERVOSet", servo, angle); }

int SERVOSetRaw(int servo, int angle) { return set("SERVOSetRaw", servo, angle); }

int SERVORange(int servo, int low, int high) {
  return robios::guarded("SERVORange", 1, [&](robios::Session& session) -> Result<int> {
    if (low < 0 || high > 255 || low >= high) {
      return fail(Errc::OutOfRange,
                  fmt::format("servo limits {}..{} are outside 0..255", low, high));
    }
    if (session.backend().servo(servo) == nullptr) {
      return robios::no_device(session, "servo", servo);
    }
    return 0;  // pulse lengths have no meaning for a simulated servo, as in EyeSim
  });
}
