#pragma once

#include <algorithm>
#include <string>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/bridges/can_bus.hpp"

namespace eyebridge::bridges {

/// Takes frames from `bus` until `until`. `tick()` does what is due and returns when it is to be
/// called again; `take(frame)` gets what comes, `lose(why)` is told that the bus does not work.
template <class Tick, class Take, class Lose>
void pump_bus(CanBus& bus, Clock& clock, Time until, const Tick& tick, const Take& take,
              const Lose& lose) {
  do {
    const Time next = std::min<Time>(tick(), until);
    const auto frame = bus.receive(next);
    if (frame) {
      take(*frame);
    } else if (frame.error().code == Errc::Disconnected) {
      lose(frame.error().what);
      clock.wait_until(next);  // A lost bus may say so at once: do not spin.
    }
  } while (clock.now() < until);
}

}  // namespace eyebridge::bridges
