#include "eyebridge/mapping/picture.hpp"

#include <cmath>
#include <limits>

namespace eyebridge::mapping {
namespace {

std::uint8_t grey_of(CellState state) {
  switch (state) {
    case CellState::Free:
      return kFreeGrey;
    case CellState::Occupied:
      return kOccupiedGrey;
    case CellState::Unknown:
      break;
  }
  return kUnknownGrey;
}

}  // namespace

Raster<std::uint8_t> picture_of(const OccupancyGrid& grid, PictureKind kind) {
  Raster<std::uint8_t> picture(grid.geometry());
  const SeenCells& cells = grid.raster().cells;
  // Most cells are as their neighbour, above all those of which nothing is known.
  float last = std::numeric_limits<float>::quiet_NaN();
  std::uint8_t grey = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i] != last) {
      last = cells[i];
      grey = kind == PictureKind::States
                 ? grey_of(grid.state_of(last))
                 : static_cast<std::uint8_t>(std::nearbyint(255.0 * (1.0 - probability_of(last))));
    }
    picture.cells[i] = grey;
  }
  return picture;
}

}  // namespace eyebridge::mapping
