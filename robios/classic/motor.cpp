// Servos and motors.

#include <algorithm>
#include <mutex>

#include <fmt/format.h>

#include "call.hpp"
#include "drive_train.hpp"
#include "eyebot.h"
#include "lookup.hpp"
#include "no_device.hpp"
#include "slots.hpp"

namespace {

using namespace eyebridge;
using robios::Session;
using robios::classic::call;
using robios::classic::describe;
using robios::classic::doing;
using robios::classic::DriveTrain;
using robios::classic::find_device;
using robios::classic::Slots;
using robios::classic::vw_motors;

struct Servos {
  std::mutex mutex;
  Slots<hal::Servo*> open{"servo", 16};
};

}  // namespace

ServoHandle SERVOInit(DeviceSemantics semantics) {
  return call("SERVOInit", 0, [&](Session& session) -> Result<int> {
    auto& servos = session.own<Servos>();
    const std::lock_guard lock(servos.mutex);
    return find_device(session.backend(), "servo", semantics).and_then([&](int id) -> Result<int> {
      hal::Servo* const servo = session.backend().servo(id);
      if (servo == nullptr) {
        return robios::no_device(session, "servo", id, "servo " + describe(semantics));
      }
      return servos.open.open(id, servo);
    });
  });
}

int SERVORelease(ServoHandle handle) {
  return call("SERVORelease", Slots<int>::kWrongHandle, [&](Session& session) -> Result<int> {
    auto& servos = session.own<Servos>();
    const std::lock_guard lock(servos.mutex);
    return servos.open.close(handle);
  });
}

int SERVOSet(ServoHandle handle, int angle) {
  return doing("SERVOSet", -1, [&](Session& session) -> Result<void> {
    if (angle < 0 || angle > 255) {
      return fail(Errc::OutOfRange, fmt::format("servo position {}, expected 0 … 255", angle));
    }
    auto& servos = session.own<Servos>();
    const std::lock_guard lock(servos.mutex);
    const auto chosen = servos.open.all(handle);
    if (!chosen) return tl::unexpected(chosen.error());
    for (hal::Servo** servo : *chosen) {
      // 128 is the middle, 1 and 255 the ends; 0 is one more step.
      const double position = std::clamp(0.5 + (angle - 128) / 254.0, 0.0, 1.0);
      if (Result<void> set = (*servo)->set(position); !set) return set;
    }
    return {};
  });
}

MotorHandle MOTORInit(DeviceSemantics semantics) {
  return call("MOTORInit", 0, [&](Session& session) -> Result<int> {
    auto& train = session.own<DriveTrain>();
    const std::lock_guard lock(train.mutex);
    return find_device(session.backend(), "motor", semantics).and_then([&](int id) -> Result<int> {
      hal::Motor* const motor = session.backend().motor(id);
      if (motor == nullptr) {
        return robios::no_device(session, "motor", id, "motor " + describe(semantics));
      }
      if (const auto vw = vw_motors(session.backend());
          train.vw_open && (id == vw[0] || id == vw[1])) {
        return fail(Errc::OutOfRange, "this motor belongs to the VW drive, which is open");
      }
      return train.motors.open(id, motor);
    });
  });
}

int MOTORRelease(MotorHandle handle) {
  return call("MOTORRelease", Slots<int>::kWrongHandle, [&](Session& session) -> Result<int> {
    auto& train = session.own<DriveTrain>();
    const std::lock_guard lock(train.mutex);
    if (const auto chosen = train.motors.all(handle)) {
      for (hal::Motor** motor : *chosen) static_cast<void>((*motor)->set_duty(0.0));
    }
    return train.motors.close(handle);
  });
}

int MOTORDrive(MotorHandle handle, int speed) {
  return doing("MOTORDrive", -1, [&](Session& session) -> Result<void> {
    auto& train = session.own<DriveTrain>();
    const std::lock_guard lock(train.mutex);
    const auto chosen = train.motors.all(handle);
    if (!chosen) return tl::unexpected(chosen.error());
    for (hal::Motor** motor : *chosen) {
      if (Result<void> set = (*motor)->set_duty(std::clamp(speed, -100, 100) / 100.0); !set) {
        return set;
      }
    }
    return {};
  });
}
