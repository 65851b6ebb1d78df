#include "eyebridge/mapping/raster.hpp"

#include <algorithm>
#include <cmath>

namespace eyebridge::mapping {
namespace {

// A floor of 2 m has 40 cells of 5 cm, though 2 / 0.05 may come out a little above 40.
int cells_over(double length, double resolution) {
  constexpr double kSlack = 1e-9;
  constexpr double kMost = 1 << 30;  // more than any grid has; also for what is no number
  return static_cast<int>(std::min(kMost, std::ceil(length / resolution - kSlack)));
}

}  // namespace

GridGeometry GridGeometry::covering(Vec2 origin, double width, double height, double resolution) {
  return {origin, resolution, cells_over(width, resolution), cells_over(height, resolution)};
}

}  // namespace eyebridge::mapping
