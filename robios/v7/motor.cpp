#include <algorithm>

#include <fmt/format.h>

#include "eyebot.h"
#include "guarded.hpp"
#include "no_device.hpp"

namespace {

using namespace eyebridge;

/// Runs `command` on motor `id`; 0 when it worked, 1 when not.
template <class Command>
int on_motor(const robios::Call& call, int id, Command&& command) {
  return robios::guarded(call, 1, [&](robios::Session& session) -> Result<int> {
    hal::Motor* motor = session.backend().motor(id);
    if (motor == nullptr) return robios::no_device(session, "motor", id);
    return command(*motor).map([] { return 0; });
  });
}

Result<hal::Encoder*> find_encoder(robios::Session& session, int id) {
  hal::Encoder* encoder = session.backend().encoder(id);
  if (encoder == nullptr) return robios::no_device(session, "encoder", id);
  return encoder;
}

double duty_of(int percent) { return std::clamp(percent, -100, 100) / 100.0; }

}  // namespace

int MOTORDrive(int motor, int speed) {
  return on_motor("MOTORDrive", motor, [&](hal::Motor& m) { return m.set_duty(duty_of(speed)); });
}

int MOTORDriveRaw(int motor, int speed) {
  return on_motor("MOTORDriveRaw", motor,
                  [&](hal::Motor& m) { return m.set_duty(duty_of(speed)); });
}

int MOTORPID(int motor, int p, int i, int d) {
  return on_motor("MOTORPID", motor, [&](hal::Motor& m) { return m.set_pid(p, i, d); });
}

int MOTORPIDOff(int motor) {
  return on_motor("MOTORPIDOff", motor, [](hal::Motor& m) { return m.set_duty(0.0); });
}

int MOTORSpeed(int motor, int ticks) {
  return on_motor("MOTORSpeed", motor, [&](hal::Motor& m) -> Result<void> {
    if (ticks < -128 || ticks > 127) {
      return fail(Errc::OutOfRange, fmt::format("{} ticks per 1/100 s, expected -128..127", ticks));
    }
    return m.set_speed(ticks * 100.0);
  });
}

int ENCODERRead(int quad) {
  return robios::guarded("ENCODERRead", 1, [&](robios::Session& session) -> Result<int> {
    return find_encoder(session, quad).and_then([](hal::Encoder* e) { return e->read(); });
  });
}

int ENCODERReset(int quad) {
  return robios::guarded("ENCODERReset", 1, [&](robios::Session& session) -> Result<int> {
    return find_encoder(session, quad).and_then([](hal::Encoder* e) {
      return e->reset().map([] { return 0; });
    });
  });
}
