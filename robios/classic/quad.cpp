#include <mutex>

#include "call.hpp"
#include "drive_train.hpp"
#include "eyebot.h"
#include "lookup.hpp"
#include "no_device.hpp"

namespace {

using namespace eyebridge;
using robios::Session;
using robios::classic::call;
using robios::classic::doing;
using robios::classic::DriveTrain;
using robios::classic::find_device;
using robios::classic::Quad;

double ticks_per_metre(hal::Backend& backend, int id) {
  for (const hal::DeviceFacts& facts : backend.facts_of("encoder")) {
    if (facts.id == id) return facts.ticks_per_metre;
  }
  return 0.0;
}

Result<std::uint32_t> ticks_of(const Quad& quad) {
  return quad.encoder->read().map([](int ticks) { return static_cast<std::uint32_t>(ticks); });
}

/// Runs `act(quad)`, which gives Result<void>, for each encoder of the mask.
template <class Act>
int for_each_quad(const robios::Call& name, QuadHandle handle, Act&& act) {
  return doing(name, -1, [&](Session& session) -> Result<void> {
    auto& train = session.own<DriveTrain>();
    const std::lock_guard lock(train.mutex);
    const auto chosen = train.quads.all(handle);
    if (!chosen) return tl::unexpected(chosen.error());
    for (Quad* quad : *chosen) {
      if (Result<void> done = act(*quad); !done) return done;
    }
    return {};
  });
}

}  // namespace

QuadHandle QUADInit(DeviceSemantics semantics) {
  return call("QUADInit", 0, [&](Session& session) -> Result<int> {
    auto& train = session.own<DriveTrain>();
    const std::lock_guard lock(train.mutex);
    hal::Backend& backend = session.backend();
    Result<int> id = find_device(backend, "encoder", semantics);
    if (!id) return id;
    hal::Encoder* const encoder = backend.encoder(*id);
    if (encoder == nullptr) {
      return robios::no_device(session, "encoder", *id,
                               "encoder " + robios::classic::describe(semantics));
    }
    if (train.vw_open && (*id == DriveTrain::kLeft || *id == DriveTrain::kRight)) {
      return fail(Errc::OutOfRange, "this encoder belongs to the VW drive, which is open");
    }
    Quad quad{encoder, ticks_per_metre(backend, *id), 0};
    return ticks_of(quad).and_then([&](std::uint32_t ticks) {
      quad.odometer_began = ticks;
      return train.quads.open(*id, quad);
    });
  });
}

int QUADRelease(QuadHandle handle) {
  return call("QUADRelease", -1, [&](Session& session) -> Result<int> {
    auto& train = session.own<DriveTrain>();
    const std::lock_guard lock(train.mutex);
    const auto chosen = train.quads.all(handle);
    if (!chosen) return tl::unexpected(chosen.error());
    return train.quads.close(handle);
  });
}

int QUADReset(QuadHandle handle) {
  return for_each_quad("QUADReset", handle, [](Quad& quad) {
    return ticks_of(quad).and_then([&](std::uint32_t ticks) {
      return quad.encoder->reset().map([&] { quad.odometer_began -= ticks; });
    });
  });
}

int QUADRead(QuadHandle handle) {
  return call("QUADRead", 0, [&](Session& session) -> Result<int> {
    auto& train = session.own<DriveTrain>();
    const std::lock_guard lock(train.mutex);
    return train.quads.one(handle).and_then([](Quad* quad) { return quad->encoder->read(); });
  });
}

DeviceSemantics QUADGetMotor(DeviceSemantics semantics) {
  return call("QUADGetMotor", DeviceSemantics{0}, [&](Session&) -> Result<DeviceSemantics> {
    switch (robios::classic::number_of(semantics)) {
      case QUAD_LEFT:
        return MOTOR_LEFT;
      case QUAD_RIGHT:
        return MOTOR_RIGHT;
      default:
        return fail(Errc::OutOfRange, robios::classic::describe(semantics) + " is no encoder");
    }
  });
}

float QUADODORead(QuadHandle handle) {
  return call("QUADODORead", 0.0F, [&](Session& session) -> Result<float> {
    auto& train = session.own<DriveTrain>();
    const std::lock_guard lock(train.mutex);
    return train.quads.one(handle).and_then([](Quad* quad) -> Result<float> {
      if (quad->ticks_per_metre == 0.0) {
        return fail(Errc::Unsupported, "nothing says how many ticks this encoder makes a metre");
      }
      return ticks_of(*quad).map([&](std::uint32_t ticks) {
        // Backwards is less than nothing, and 32 bits wrap around.
        const auto driven = static_cast<std::int32_t>(ticks - quad->odometer_began);
        return static_cast<float>(driven / quad->ticks_per_metre);
      });
    });
  });
}

int QUADODOReset(QuadHandle handle) {
  return for_each_quad("QUADODOReset", handle, [](Quad& quad) {
    return ticks_of(quad).map([&](std::uint32_t ticks) { quad.odometer_began = ticks; });
  });
}
