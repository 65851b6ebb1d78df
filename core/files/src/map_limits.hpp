#pragma once

#include <cstddef>

#include "eyebridge/mapping/raster.hpp"

namespace eyebridge::files {

// What maps in files are like; a grid that is not is no map.
inline constexpr double kLeastResolution = 1e-4;  // metres
inline constexpr double kMostResolution = 1e3;
inline constexpr double kMostOrigin = 1e6;
inline constexpr double kMostYaw = 100.0;  // radians

/// Throws ConfigError for a grid that no reader would take back.
void need_readable(const mapping::GridGeometry& geometry);

}  // namespace eyebridge::files
