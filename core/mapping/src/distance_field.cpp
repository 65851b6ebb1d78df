#include "eyebridge/mapping/distance_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "eyebridge/mapping/envelope.hpp"

namespace eyebridge::mapping {
namespace {

// More cells than any column has.
constexpr std::int32_t kNoneInColumn = 1 << 15;

/// Cells up or down to the nearest occupied one of the same column.
std::vector<std::int32_t> column_distances(const Raster<std::uint8_t>& occupied) {
  const auto columns = static_cast<std::size_t>(occupied.geometry.columns);
  const std::size_t size = occupied.cells.size();
  std::vector<std::int32_t> away(size);
  for (std::size_t i = 0; i < size; ++i) {
    const std::int32_t below = i < columns ? kNoneInColumn : away[i - columns] + 1;
    away[i] = occupied.cells[i] != 0 ? 0 : std::min(below, kNoneInColumn);
  }
  for (std::size_t i = size - std::min(columns, size); i-- > 0;) {
    away[i] = std::min(away[i], away[i + columns] + 1);
  }
  return away;
}

}  // namespace

Raster<float> distance_field(const Raster<std::uint8_t>& occupied) {
  Raster<float> field(occupied.geometry, std::numeric_limits<float>::infinity());
  const auto columns = static_cast<std::size_t>(occupied.geometry.columns);
  const std::vector<std::int32_t> away = column_distances(occupied);
  Envelope envelope(columns);
  for (std::size_t row = 0; row < away.size(); row += columns) {
    envelope.clear();
    for (std::size_t i = 0; i < columns; ++i) {
      const Envelope::Number own = away[row + i];
      if (own < kNoneInColumn) envelope.add(static_cast<Envelope::Number>(i), own * own);
    }
    const auto end = static_cast<Envelope::Number>(columns);
    envelope.each(0, 1, end, [&](Envelope::Number x, Envelope::Number squared) {
      const double cells = std::sqrt(static_cast<double>(squared));
      field.cells[row + static_cast<std::size_t>(x)] =
          static_cast<float>(occupied.geometry.resolution * cells);
    });
  }
  return field;
}

}  // namespace eyebridge::mapping
