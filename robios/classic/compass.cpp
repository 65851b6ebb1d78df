#include <cmath>
#include <mutex>
#include <optional>

#include <fmt/format.h>

#include "call.hpp"
#include "eyebot.h"
#include "eyebridge/base/units.hpp"
#include "lookup.hpp"

namespace {

using namespace eyebridge;
using robios::Session;
using robios::classic::call;
using robios::classic::doing;

// A measurement of the module takes a tenth of a second.
constexpr Time kMeasurement = std::chrono::milliseconds(100);

struct CompassModule {
  std::mutex mutex;
  bool open = false;
  std::optional<Time> started;
  bool again_and_again = false;
  long long measured = 0;      ///< Which measurement `degrees` is of, from 1.
  std::optional<int> degrees;  ///< The last result; outlives stopping.

  void reset(bool is_open) {
    open = is_open;
    started.reset();
    again_and_again = false;
    measured = 0;
    degrees.reset();
  }
};

/// Clockwise from +y, of an angle counter-clockwise from +x.
int bearing_of(double heading) {
  const auto whole = static_cast<int>(std::lround(90.0 - rad_to_deg(heading)));
  return (whole % 360 + 360) % 360;
}

/// Under the module's lock, as take_result().
Result<hal::Compass*> open_module(Session& session) {
  hal::Compass* const compass = session.backend().compass();
  if (compass == nullptr || !session.own<CompassModule>().open) {
    return fail(Errc::Unsupported, "the compass is not initialised: call COMPASSInit first");
  }
  return compass;
}

/// Takes the result of a measurement that is done by now, if there is a new one.
Result<void> take_result(CompassModule& unit, hal::Compass& compass, Time now) {
  if (!unit.started) return {};
  const long long done = (now - *unit.started) / kMeasurement;
  const long long last = unit.again_and_again || done < 1 ? done : 1;
  if (last == unit.measured) return {};
  return compass.read().map([&](double heading) {
    unit.degrees = bearing_of(heading);
    unit.measured = last;
  });
}

}  // namespace

int COMPASSInit(DeviceSemantics semantics) {
  return doing("COMPASSInit", 1, [&](Session& session) -> Result<void> {
    const Result<int> id = robios::classic::find_device(session.backend(), "compass", semantics);
    if (!id) return tl::unexpected(id.error());
    if (session.backend().compass() == nullptr) {
      return fail(Errc::NoDevice, "this robot has no compass");
    }
    auto& unit = session.own<CompassModule>();
    const std::lock_guard lock(unit.mutex);
    unit.reset(true);
    return {};
  });
}

int COMPASSStart(BOOL cycle) {
  return call("COMPASSStart", 1, [&](Session& session) -> Result<int> {
    auto& unit = session.own<CompassModule>();
    const std::lock_guard lock(unit.mutex);
    return open_module(session).map([&](hal::Compass*) {
      const Time now = session.clock().now();
      const bool busy =
          unit.started && (unit.again_and_again || now - *unit.started < kMeasurement);
      if (busy) return 1;
      unit.started = now;
      unit.again_and_again = cycle != 0;
      unit.measured = 0;
      unit.degrees.reset();
      return 0;
    });
  });
}

int COMPASSCheck(void) {
  return call("COMPASSCheck", 0, [](Session& session) -> Result<int> {
    auto& unit = session.own<CompassModule>();
    const std::lock_guard lock(unit.mutex);
    return open_module(session).and_then([&](hal::Compass* compass) {
      return take_result(unit, *compass, session.clock().now()).map([&] {
        return unit.degrees ? 1 : 0;
      });
    });
  });
}

int COMPASSStop(void) {
  return doing("COMPASSStop", 1, [](Session& session) -> Result<void> {
    auto& unit = session.own<CompassModule>();
    std::optional<Time> end;
    {
      const std::lock_guard lock(unit.mutex);
      if (const auto compass = open_module(session); !compass) {
        return tl::unexpected(compass.error());
      }
      if (unit.started) {
        const long long done = (session.clock().now() - *unit.started) / kMeasurement;
        if (done < 1 || unit.again_and_again) end = *unit.started + (done + 1) * kMeasurement;
      }
    }
    if (!end) return {};
    robios::classic::wait_until(*end);
    const std::lock_guard lock(unit.mutex);
    return open_module(session).and_then([&](hal::Compass* compass) {
      return take_result(unit, *compass, session.clock().now()).map([&] { unit.started.reset(); });
    });
  });
}

int COMPASSRelease(void) {
  return doing("COMPASSRelease", 1, [](Session& session) -> Result<void> {
    auto& unit = session.own<CompassModule>();
    const std::lock_guard lock(unit.mutex);
    return open_module(session).map([&](hal::Compass*) { unit.reset(false); });
  });
}

int COMPASSGet(void) {
  return call("COMPASSGet", -1, [](Session& session) -> Result<int> {
    auto& unit = session.own<CompassModule>();
    const std::lock_guard lock(unit.mutex);
    return open_module(session).and_then([&](hal::Compass* compass) {
      return take_result(unit, *compass, session.clock().now()).map([&] {
        return unit.degrees.value_or(-1);
      });
    });
  });
}

int COMPASSCalibrate(int mode) {
  return doing("COMPASSCalibrate", 1, [&](Session& session) -> Result<void> {
    auto& unit = session.own<CompassModule>();
    const std::lock_guard lock(unit.mutex);
    if (const auto compass = open_module(session); !compass) {
      return tl::unexpected(compass.error());
    }
    if (mode == 0 || mode == 1) return {};
    return fail(Errc::OutOfRange, fmt::format("mode {}, expected 0 or 1", mode));
  });
}
