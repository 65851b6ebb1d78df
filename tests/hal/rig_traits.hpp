#pragma once

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/units.hpp"

namespace eyebridge::hal {

/// What a row's robot has, and how exactly its numbers are known. What a row has not, the contract
/// asserts to be null, or to fail as it should: nothing is left out.
struct RigTraits {
  enum class LidarKind {
    None,
    AsBuilt,  ///< A shape selects rays of the robot's own scans.
    Free,     ///< Any shape.
  };
  bool world = true;      ///< World control, a camera's view, and a trace that knows the truth.
  bool one_world = true;  ///< Its camera sees the world that its world control changes.
  bool switches = true;   ///< Proximity switches and bumpers.
  bool compass = true;
  bool inertial = true;  ///< Gyroscope and accelerometer.
  bool stalls = true;    ///< Says which wheel is held.
  bool lines = true;     ///< Digital lines, analog inputs, a version.
  bool gains = true;     ///< Of its motors' controllers.
  LidarKind lidar = LidarKind::Free;
  bool range_matrix = true;
  int motors = 2;  ///< And encoders: 1 … this.
  int servos = 2;
  Time trace_period = from_seconds(0.01);  ///< Between points at least; 0: there is no trace.
  int raw_at_half_metre = 500;             ///< read_raw() of a sensor 0.5 m before a wall.

  // Tolerances.
  double range = 1e-9;    ///< Of a distance up to 2 m, metres.
  double way = 1e-3;      ///< Of a finished movement and of odometry, metres.
  double turn = 1e-3;     ///< Likewise, radians.
  double linear = 1e-2;   ///< Of a measured speed, metres per second.
  double angular = 2e-2;  ///< Likewise, radians per second.
  double servo = 1e-9;    ///< Of a servo's angle, radians.
  double age = 0.0;       ///< How old a reading may be, seconds.
};

// One tick of a wheel is 0.154 mm (1100 a turn of 54 mm): 1.7 mrad of heading on a base of 90 mm. A
// goal between two ticks is reached at either. The boards' curve of a distance sensor has steps of
// (r + 0.5 m)^2 / 2047.5 m, 3.05 mm at 2 m, and its table has whole millimetres: half of both is
// 2.1 mm. Speeds are measured over 50 ms, to a tick at either end: 6.2 mm/s, and 68 mrad/s for one
// of each wheel. A servo has 256 positions over half a turn of the camera, 12 mrad each.

inline constexpr RigTraits kSimulated{};

/// Nothing but the calls that were recorded: no world, and nobody knows where the robot was.
inline constexpr RigTraits kReplayed = [] {
  RigTraits traits = kSimulated;
  traits.world = false;
  traits.trace_period = Time{0};
  return traits;
}();

/// What all boards lack and what they measure with.
inline constexpr RigTraits kBoard = [] {
  RigTraits traits;
  traits.world = false;
  traits.switches = false;  // they are digital inputs, which no backend has names for
  traits.compass = false;   // no board has one
  traits.inertial = false;  // likewise
  traits.trace_period = from_seconds(0.1);
  traits.raw_at_half_metre = 2048;  // 2 047 500 / (500 + 500), to the nearest
  traits.range = 2.2e-3;
  traits.linear = 6.2e-3;
  traits.angular = 0.068;
  traits.servo = kPi / 255;
  return traits;
}();

/// IO7, driven by the host from encoder counts that are up to two periods old.
inline constexpr RigTraits kIo7HostVw = [] {
  RigTraits traits = kBoard;
  traits.lidar = RigTraits::LidarKind::None;  // IO7 has no letter for it
  traits.range_matrix = false;                // nor for this
  traits.way = 2e-3;
  traits.turn = 8e-3;
  traits.linear += 0.02 * 0.34;  // when a count was made is known to a millisecond of the 50
  traits.angular += 0.02 * 0.5;
  traits.age = 0.02;
  return traits;
}();

/// IO7, driven by the board. Its letters carry whole millimetres and degrees: half a degree is
/// 8.7 mrad, and a millimetre of rounding at a goal another.
inline constexpr RigTraits kIo7BoardVw = [] {
  RigTraits traits = kBoard;
  traits.lidar = RigTraits::LidarKind::None;
  traits.range_matrix = false;
  traits.stalls = false;  // no letter tells, see hal/board/README.md
  traits.way = 2e-3;
  traits.turn = deg_to_rad(0.5) + 3e-3;
  traits.linear += 0.5e-3;
  traits.angular += deg_to_rad(0.5);
  traits.age = 0.02;
  return traits;
}();

/// CAN with an HDT file: status every 20 ms, distances every 50 ms, millimetres and 0.01 degrees.
inline constexpr RigTraits kCan = [] {
  RigTraits traits = kBoard;
  traits.lidar = RigTraits::LidarKind::AsBuilt;
  traits.way = 2e-3;
  traits.turn = 4e-3;
  traits.age = 0.07;
  return traits;
}();

/// CAN without one: no frame says what is connected, so there is all that a board can have.
inline constexpr RigTraits kCanWithoutHdt = [] {
  RigTraits traits = kCan;
  traits.motors = 4;
  traits.servos = 14;
  return traits;
}();

/// A robot with messages of its own: counts every 10 ms, each distance every 40 ms, and no more
/// than its messages carry.
inline constexpr RigTraits kRover = [] {
  RigTraits traits = kIo7HostVw;
  traits.lines = false;
  traits.gains = false;
  traits.servos = 0;
  traits.raw_at_half_metre = 500;  // its distances are millimetres
  traits.age = 0.06;
  return traits;
}();

/// Both ends are on threads that a busy computer lets wait: a reading gets that much older, and the
/// host takes a count for one of then: 20 ms in the 50 over which it measures a speed are two
/// fifths of it (of at most 0.6 m/s, 1 rad/s). A host that is late at a goal drives past it, and
/// back.
constexpr RigTraits in_real_time(RigTraits traits) {
  traits.age += 0.05;
  traits.way += 3e-3;
  traits.turn += 0.02;
  traits.linear += 0.24;
  traits.angular += 0.4;
  return traits;
}

}  // namespace eyebridge::hal
