#pragma once

#include <cstdint>

#include "eyebridge/mapping/occupancy_grid.hpp"

namespace eyebridge::mapping {

/// Grey of cells in ROS's maps.
inline constexpr std::uint8_t kOccupiedGrey = 0;
inline constexpr std::uint8_t kUnknownGrey = 205;
inline constexpr std::uint8_t kFreeGrey = 254;

/// How cells become grey.
enum class PictureKind {
  States,         ///< The three greys of ROS's map_saver: what a `trinary` map holds.
  Probabilities,  ///< 255 for probability 0 … 0 for 1.
};

/// Grey levels of `grid`, in the order of its cells: from the lower left one, where pictures begin
/// at the upper left.
Raster<std::uint8_t> picture_of(const OccupancyGrid& grid, PictureKind kind = PictureKind::States);

}  // namespace eyebridge::mapping
