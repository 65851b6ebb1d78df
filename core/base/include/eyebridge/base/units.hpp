#pragma once

#include <numbers>

namespace eyebridge {

// Inside EyeBridge everything is metres, radians and seconds. These factors are used only where
// another unit enters or leaves: robios/ (mm, degrees), bridges/ messages, and the file readers.
// They take any number, and round once or twice as doubles do; any thread.

/// Half a turn, radians.
inline constexpr double kPi = std::numbers::pi;

/// Metres of `mm` millimetres.
constexpr double mm_to_m(double mm) { return mm / 1000.0; }
/// Millimetres of `m` metres.
constexpr double m_to_mm(double m) { return m * 1000.0; }
/// Radians of `deg` degrees; exact for 90, 180 and 360.
constexpr double deg_to_rad(double deg) { return deg * (kPi / 180.0); }
/// Degrees of `rad` radians.
constexpr double rad_to_deg(double rad) { return rad * (180.0 / kPi); }
/// Metres of `cm` centimetres.
constexpr double cm_to_m(double cm) { return cm / 100.0; }

}  // namespace eyebridge
