#include <mutex>
#include <optional>

#include "call.hpp"
#include "convert.hpp"
#include "eyebot.h"
#include "lookup.hpp"
#include "no_device.hpp"
#include "psd_cycle.hpp"
#include "slots.hpp"

namespace {

using namespace eyebridge;
using robios::Session;
using robios::classic::call;
using robios::classic::doing;
using robios::classic::PsdCycle;
using robios::classic::Slots;

constexpr std::size_t kMostPsds = 8;

/// A sensor, and its readings of the last measurement.
struct Psd {
  hal::RangeSensor* sensor = nullptr;
  long long measured = 0;  ///< PsdCycle::number() of what follows.
  std::optional<int> range_mm;
  std::optional<int> raw;
};

struct Psds {
  std::mutex mutex;
  Slots<Psd> open{"PSD", kMostPsds};
  PsdCycle cycle;
};

Result<int> read_mm(hal::RangeSensor& sensor) {
  return sensor.read().map([&](double range) {
    return range >= sensor.out_of_range() ? PSD_OUT_OF_RANGE : robios::to_mm(range);
  });
}

/// The reading that `field` of a sensor keeps: a measurement gives the same one as long as it is
/// the last.
template <class Read>
Result<int> reading(Session& session, PSDHandle handle, std::optional<int> Psd::*field,
                    Read&& read) {
  auto& psds = session.own<Psds>();
  const std::lock_guard lock(psds.mutex);
  const Time now = session.clock().now();
  if (handle == 0) return static_cast<int>(psds.cycle.began(now) / robios::classic::kTick);
  const Result<Psd*> found = psds.open.one(handle);
  if (!found) return tl::unexpected(found.error());
  Psd& psd = **found;
  const long long number = (psds.cycle.mask() & handle) != 0 ? psds.cycle.number(now) : 0;
  if (number != 0 && number == psd.measured && psd.*field) return *(psd.*field);
  Result<int> value = read(*psd.sensor);
  if (!value) return value;
  if (number != psd.measured) {
    psd.range_mm.reset();
    psd.raw.reset();
  }
  psd.measured = number;
  psd.*field = *value;
  return value;
}

}  // namespace

PSDHandle PSDInit(DeviceSemantics semantics) {
  return call("PSDInit", 0, [&](Session& session) -> Result<int> {
    auto& psds = session.own<Psds>();
    const std::lock_guard lock(psds.mutex);
    return robios::classic::find_device(session.backend(), "psd", semantics)
        .and_then([&](int id) -> Result<int> {
          hal::RangeSensor* const sensor = session.backend().range_sensor(id);
          if (sensor == nullptr) {
            return robios::no_device(session, "PSD", id,
                                     "PSD " + robios::classic::describe(semantics));
          }
          return psds.open.open(id, {sensor, 0, {}, {}});
        });
  });
}

int PSDRelease(void) {
  return doing("PSDRelease", 1, [](Session& session) -> Result<void> {
    auto& psds = session.own<Psds>();
    const std::lock_guard lock(psds.mutex);
    psds.open.close_all();
    psds.cycle.stop();
    return {};
  });
}

int EYEBRIDGEPSDRelease(int given, PSDHandle handle) {
  if (given == 0) return PSDRelease();
  return call("PSDRelease", 1, [&](Session& session) -> Result<int> {
    auto& psds = session.own<Psds>();
    const std::lock_guard lock(psds.mutex);
    const auto known = psds.open.all(handle);
    if (!known) return tl::unexpected(known.error());
    return psds.open.close(handle);
  });
}

int PSDStart(PSDHandle bitmask, BOOL cycle) {
  return call("PSDStart", -1, [&](Session& session) -> Result<int> {
    auto& psds = session.own<Psds>();
    const std::lock_guard lock(psds.mutex);
    const auto known = psds.open.all(bitmask);
    if (!known) return tl::unexpected(known.error());
    return psds.cycle.start(bitmask, cycle != 0, session.clock().now()) ? 0 : 1;
  });
}

int PSDStop(void) {
  return doing("PSDStop", 1, [](Session& session) -> Result<void> {
    auto& psds = session.own<Psds>();
    const std::lock_guard lock(psds.mutex);
    psds.cycle.stop();
    return {};
  });
}

BOOL PSDCheck(void) {
  return call("PSDCheck", FALSE, [](Session& session) -> Result<int> {
    auto& psds = session.own<Psds>();
    const std::lock_guard lock(psds.mutex);
    return psds.cycle.is_ready(session.clock().now()) ? TRUE : FALSE;
  });
}

int PSDGet(PSDHandle handle) {
  return call("PSDGet", -1,
              [&](Session& session) { return reading(session, handle, &Psd::range_mm, read_mm); });
}

int PSDGetRaw(PSDHandle handle) {
  return call("PSDGetRaw", -1, [&](Session& session) {
    return reading(session, handle, &Psd::raw,
                   [](hal::RangeSensor& sensor) { return sensor.read_raw(); });
  });
}
