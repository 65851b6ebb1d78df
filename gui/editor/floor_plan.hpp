#pragma once

#include <QImage>
#include <optional>
#include <vector>

#include "eyebridge/world/world_model.hpp"

namespace eyebridge::gui {

/// How a picture of a floor plan becomes walls.
struct FloorPlanOptions {
  double metres_per_pixel = 0.01;  ///< > 0.
  std::optional<int> threshold{};  ///< Darker pixels are wall, 1 … 255; none: found by itself.
  double tolerance = 1.0;          ///< Pixels that a wall may miss the outline by, >= 0.
};

/// What a picture shows; the floor is as large as it is.
struct FloorPlan {
  double width = 0.0;   ///< Metres.
  double height = 0.0;  ///< Metres.
  std::vector<world::Wall> walls;
};

/// The outlines of what is dark in `picture`, as walls without thickness.
///
/// The threshold is Otsu's (IEEE Transactions on Systems, Man, and Cybernetics 9, 1979), the
/// outlines are followed along the cracks between pixels (Rosenfeld and Kak, Digital Picture
/// Processing, 1982, chapter 11) and straightened as by Douglas and Peucker (Cartographica 10,
/// 1973). Transparent pixels are light. Throws ConfigError for a picture without pixels, without
/// anything dark or with more than 100,000 walls.
FloorPlan read_floor_plan(const QImage& picture, const FloorPlanOptions& options);

}  // namespace eyebridge::gui
