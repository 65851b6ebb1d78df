#pragma once

#include <cstddef>
#include <optional>

#include "eyebridge/files/map_files.hpp"
#include "eyebridge/mapping/raster.hpp"

namespace eyebridge::files {

/// Where the pixels of a map lie in the world.
class MapFrame {
 public:
  MapFrame(const MapDescription& map, int columns, int rows);

  /// The place of a corner of pixels: `x` to the right, `y` down from the upper left one.
  [[nodiscard]] Vec2 place(double x, double y) const;
  /// Lower left and upper right corner of the smallest box along the axes that has all of it.
  [[nodiscard]] Vec2 low() const { return low_; }
  [[nodiscard]] Vec2 high() const { return high_; }

  /// The smallest grid along the axes, with cells as large as pixels, that has all of it.
  [[nodiscard]] mapping::GridGeometry covering() const;
  /// Index of the pixel under the centre of a cell of covering(); nothing: beside the picture.
  [[nodiscard]] std::optional<std::size_t> pixel_at(const mapping::GridGeometry& geometry,
                                                    mapping::Cell cell) const;

 private:
  Vec2 origin_;
  double resolution_;
  int columns_;
  int rows_;
  Vec2 right_;  ///< Along a row of pixels; of length 1.
  Vec2 up_;     ///< Against a column.
  bool is_turned_;
  Vec2 low_;
  Vec2 high_;
};

}  // namespace eyebridge::files
