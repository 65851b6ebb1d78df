#pragma once

#include <numbers>

namespace eyebridge {

// Inside EyeBridge everything is metres, radians and seconds. These factors are used only where
// another unit enters or leaves: robios/ (mm, degrees), bridges/ messages, and the file readers.

inline constexpr double kPi = std::numbers::pi;

constexpr double mm_to_m(double mm) { return mm / 1000.0; }
constexpr double m_to_mm(double m) { return m * 1000.0; }
constexpr double deg_to_rad(double deg) { return deg * (kPi / 180.0); }
constexpr double rad_to_deg(double rad) { return rad * (180.0 / kPi); }
constexpr double cm_to_m(double cm) { return cm / 100.0; }

}  // namespace eyebridge
