#pragma once

#include <cstdint>

#include "eyebridge/mapping/raster.hpp"

namespace eyebridge::mapping {

/// How far the centre of each cell is from the centre of the nearest occupied one (!= 0), metres;
/// infinite everywhere when none is.
///
/// Exact (Euclidean), in time proportional to the number of cells: lower envelope of parabolas,
/// P. Felzenszwalb and D. Huttenlocher, "Distance Transforms of Sampled Functions", Theory of
/// Computing 8 (2012) 415. `occupied` has less than 2^15 columns and rows. Any thread.
Raster<float> distance_field(const Raster<std::uint8_t>& occupied);

}  // namespace eyebridge::mapping
