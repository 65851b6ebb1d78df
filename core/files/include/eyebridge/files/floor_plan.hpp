#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "eyebridge/files/map_files.hpp"
#include "eyebridge/world/world_model.hpp"

namespace eyebridge::files {

/// How many walls a picture may give.
inline constexpr std::size_t kMostPictureWalls = 100000;

/// A corner of pixels: `x` to the right, `y` down, from the upper left one.
struct PixelCorner {
  int x = 0;
  int y = 0;

  friend bool operator==(const PixelCorner&, const PixelCorner&) = default;
};

/// The outlines of what is dark in a picture of `columns` x `rows`, `dark` from the upper left
/// pixel, row by row. Each is closed; its last corner is not the first one again. It misses the
/// pixels by at most `tolerance` of them.
///
/// They are followed along the cracks between pixels (Rosenfeld and Kak, Digital Picture
/// Processing, 1982, chapter 11) and straightened as by Douglas and Peucker (Cartographica 10,
/// 1973). Throws ConfigError for more than kMostPictureWalls; `file` names the picture.
std::vector<std::vector<PixelCorner>> outlines_of(int columns, int rows,
                                                  const std::vector<char>& dark, double tolerance,
                                                  const std::string& file);

/// The same of the pixels whose grey is at most `darkest`.
std::vector<std::vector<PixelCorner>> outlines_of(const GreyPicture& picture, int darkest,
                                                  double tolerance, const std::string& file);

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

/// The outlines of what is dark in `picture`, as walls without thickness. The threshold is Otsu's
/// (IEEE Transactions on Systems, Man, and Cybernetics 9, 1979). Throws ConfigError for a picture
/// without anything dark, and as outlines_of().
FloorPlan read_floor_plan(const GreyPicture& picture, const FloorPlanOptions& options,
                          const std::string& file);

}  // namespace eyebridge::files
