#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "eyebridge/robot/robot_model.hpp"

namespace eyebridge::robot {

/// The names of the scanners that lidar_preset() knows.
inline constexpr std::array<std::string_view, 4> kLidarPresets = {"LMS200", "LMS200-1", "URG-04LX",
                                                                  "RPLIDAR-A1"};

/// A scanner like the one of that name, case as written: rays, field of view, reach, errors; level,
/// in the middle of the robot. Nothing when there is none of the name.
///
/// - LMS200: 180 degrees every half degree, to 8 m (in millimetre mode), sigma 5 mm (SICK,
///   "LMS200/211/221/291 Laser Measurement Systems. Technical Description"); LMS200-1 every degree.
/// - URG-04LX: 682 steps of 360/1024 degrees, to 4 m; 10 mm up to 1 m, then 1 % of the range
///   (Hokuyo, "Scanning laser range finder URG-04LX. Specifications").
/// - RPLIDAR-A1: 360 rays all round (at 5.5 Hz), to 12 m on something white; 1 % of the range
///   (Slamtec, "RPLIDAR A1 Introduction and Datasheet").
///
/// Where the maker tells how far off a range may be, a third of that is taken for sigma. Blind
/// ranges before the device, and how dark or slanted things are, play no part (L. Kneip and others,
/// "Characterization of the compact Hokuyo URG-04LX", ICRA 2009, say how much they do).
std::optional<LidarModel> lidar_preset(std::string_view name);

}  // namespace eyebridge::robot
