#include "eyebridge/mapping/picture.hpp"

#include <cmath>

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
  const std::vector<float>& cells = grid.raster().cells;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (kind == PictureKind::States) {
      picture.cells[i] = grey_of(grid.state_of(cells[i]));
    } else {
      const double free = 1.0 - probability_of(cells[i]);
      picture.cells[i] = static_cast<std::uint8_t>(std::nearbyint(255.0 * free));
    }
  }
  return picture;
}

}  // namespace eyebridge::mapping
