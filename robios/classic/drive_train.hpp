#pragma once

#include <cstdint>
#include <mutex>
#include <optional>

#include "eyebot.h"
#include "eyebridge/base/clock.hpp"
#include "eyebridge/hal/motor.hpp"
#include "slots.hpp"

namespace eyebridge::robios::classic {

/// An encoder and what QUADODORead() counts with.
struct Quad {
  hal::Encoder* encoder = nullptr;
  double ticks_per_metre = 0.0;      ///< 0: not known.
  std::uint32_t odometer_began = 0;  ///< Ticks, as the encoder counts them.
};

/// A turn on the spot, whose remaining angle no device tells.
struct Turn {
  double angle = 0.0;    ///< Radians, as commanded.
  double speed = 0.0;    ///< Radians per second, > 0.
  double heading = 0.0;  ///< By odometry at its start.
  Time began{0};
};

/// What drives a robot: the open motors and encoders, and whether the VW drive has them. Lock
/// `mutex`. Session::own() has it.
struct DriveTrain {
  static constexpr VWHandle kVw = 1;
  // Encoders of the VW drive.
  static constexpr int kLeft = 1;
  static constexpr int kRight = 2;

  std::mutex mutex;
  Slots<hal::Motor*> motors{"motor", 16};
  Slots<Quad> quads{"encoder", 8};
  bool vw_open = false;
  std::optional<Turn> turn;  ///< The movement of the VW drive, when it is one.
};

}  // namespace eyebridge::robios::classic
