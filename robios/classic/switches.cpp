// Bumpers and infrared switches.

#include <mutex>

#include "call.hpp"
#include "eyebot.h"
#include "lookup.hpp"
#include "slots.hpp"
#include "timers.hpp"

namespace {

using namespace eyebridge;
using robios::Session;
using robios::classic::call;
using robios::classic::find_device;
using robios::classic::Slots;

constexpr std::size_t kMostSwitches = 16;

struct Bumper {
  hal::SwitchSensor* sensor = nullptr;
  bool touched = false;  ///< When it was looked at last.
  bool hit = false;      ///< Since the program asked last.
  Time hit_at{0};        ///< The first time since then.
};

struct Switches {
  std::mutex mutex;
  Slots<Bumper> bumpers{"bumper", kMostSwitches};
  Slots<hal::SwitchSensor*> proximities{"infrared switch", kMostSwitches};
  bool bumpers_watched = false;
};

/// What the robot's timer unit does by itself: it holds the first contact. One that cannot be read
/// now is asked again next time; BUMPCheck() tells of the failure.
Result<void> look_at(Bumper& bumper, Time now) {
  const Result<bool> touches = bumper.sensor->read();
  if (!touches) return tl::unexpected(touches.error());
  if (*touches && !bumper.touched && !bumper.hit) {
    bumper.hit = true;
    bumper.hit_at = now;
  }
  bumper.touched = *touches;
  return {};
}

void look_at_bumpers() {
  Session& session = Session::instance();
  auto& switches = session.own<Switches>();
  const std::lock_guard lock(switches.mutex);
  const Time now = session.clock().now();
  const auto open = switches.bumpers.all(switches.bumpers.open_mask());
  if (!open) return;
  for (Bumper* bumper : *open) static_cast<void>(look_at(*bumper, now));
}

tl::unexpected<Error> no_switch(DeviceSemantics semantics) {
  return fail(Errc::NoDevice, "this robot has no " + robios::classic::describe(semantics));
}

}  // namespace

BumpHandle BUMPInit(DeviceSemantics semantics) {
  return call("BUMPInit", 0, [&](Session& session) -> Result<int> {
    return find_device(session.backend(), "bumper", semantics).and_then([&](int id) -> Result<int> {
      hal::SwitchSensor* const sensor = session.backend().bumper(id);
      if (sensor == nullptr) return no_switch(semantics);
      auto& switches = session.own<Switches>();
      const std::lock_guard lock(switches.mutex);
      if (!switches.bumpers_watched)
        session.timers().attach(robios::classic::kTick, session.bound(look_at_bumpers));
      switches.bumpers_watched = true;
      // What it touches now it has not hit.
      return switches.bumpers.open(id, {sensor, sensor->read().value_or(false), false, Time(0)});
    });
  });
}

int BUMPRelease(BumpHandle handle) {
  return call("BUMPRelease", Slots<int>::kWrongHandle, [&](Session& session) -> Result<int> {
    auto& switches = session.own<Switches>();
    const std::lock_guard lock(switches.mutex);
    return switches.bumpers.close(handle);
  });
}

int BUMPCheck(BumpHandle handle, int* timestamp) {
  if (timestamp != nullptr) *timestamp = 0;
  return call("BUMPCheck", -1, [&](Session& session) -> Result<int> {
    auto& switches = session.own<Switches>();
    const std::lock_guard lock(switches.mutex);
    const Result<Bumper*> found = switches.bumpers.one(handle);
    if (!found) return tl::unexpected(found.error());
    Bumper& bumper = **found;
    if (const Result<void> seen = look_at(bumper, session.clock().now()); !seen && !bumper.hit) {
      return tl::unexpected(seen.error());
    }
    if (!bumper.hit) return -1;
    bumper.hit = false;
    if (timestamp != nullptr) {
      *timestamp =
          static_cast<int>(static_cast<unsigned>(bumper.hit_at / std::chrono::microseconds(1)));
    }
    return 0;
  });
}

IRHandle IRInit(DeviceSemantics semantics) {
  return call("IRInit", 0, [&](Session& session) -> Result<int> {
    return find_device(session.backend(), "proximity", semantics)
        .and_then([&](int id) -> Result<int> {
          hal::SwitchSensor* const sensor = session.backend().proximity(id);
          if (sensor == nullptr) return no_switch(semantics);
          auto& switches = session.own<Switches>();
          const std::lock_guard lock(switches.mutex);
          return switches.proximities.open(id, sensor);
        });
  });
}

int IRRelease(IRHandle handle) {
  return call("IRRelease", Slots<int>::kWrongHandle, [&](Session& session) -> Result<int> {
    auto& switches = session.own<Switches>();
    const std::lock_guard lock(switches.mutex);
    return switches.proximities.close(handle);
  });
}

int IRRead(IRHandle handle) {
  return call("IRRead", -1, [&](Session& session) -> Result<int> {
    auto& switches = session.own<Switches>();
    const std::lock_guard lock(switches.mutex);
    return switches.proximities.one(handle).and_then([](hal::SwitchSensor** sensor) {
      return (*sensor)->read().map([](bool near) { return near ? 1 : 0; });
    });
  });
}
