#pragma once

namespace eyebridge::camera {

/// Of the disc that a marker is painted as, metres.
inline constexpr double kMarkerRadius = 0.05;

}  // namespace eyebridge::camera
