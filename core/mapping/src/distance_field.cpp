#include "eyebridge/mapping/distance_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

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

/// The lower envelope of the parabolas that stand in one row of cells.
class Envelope {
 public:
  explicit Envelope(std::size_t columns) : places_(columns), heights_(columns), starts_(columns) {}

  /// Squared distances, in cells, along a row whose columns have `away` to their nearest cell.
  void run(const std::int32_t* away, std::size_t columns, double* squares) {
    count_ = 0;
    for (std::size_t q = 0; q < columns; ++q) {
      if (away[q] < kNoneInColumn) add(static_cast<double>(q), away[q]);
    }
    if (count_ == 0) {
      std::fill(squares, squares + columns, std::numeric_limits<double>::infinity());
      return;
    }
    std::size_t k = 0;
    for (std::size_t q = 0; q < columns; ++q) {
      const auto at = static_cast<double>(q);
      while (k + 1 < count_ && starts_[k + 1] < at) ++k;
      squares[q] = (at - places_[k]) * (at - places_[k]) + heights_[k];
    }
  }

 private:
  void add(double place, double away) {
    const double height = away * away;
    double start = -std::numeric_limits<double>::infinity();
    while (count_ > 0) {
      // Where the new parabola falls below the last one of the envelope.
      const double last = places_[count_ - 1];
      start = ((height + place * place) - (heights_[count_ - 1] + last * last)) /
              (2.0 * (place - last));
      if (start > starts_[count_ - 1]) break;
      --count_;
    }
    if (count_ == 0) start = -std::numeric_limits<double>::infinity();
    places_[count_] = place;
    heights_[count_] = height;
    starts_[count_++] = start;
  }

  std::vector<double> places_;   ///< Column of each parabola.
  std::vector<double> heights_;  ///< Of its lowest point.
  std::vector<double> starts_;   ///< From where on it is the lowest one.
  std::size_t count_ = 0;
};

}  // namespace

Raster<float> distance_field(const Raster<std::uint8_t>& occupied) {
  Raster<float> field(occupied.geometry);
  const auto columns = static_cast<std::size_t>(occupied.geometry.columns);
  const auto rows = static_cast<std::size_t>(occupied.geometry.rows);
  const std::vector<std::int32_t> away = column_distances(occupied);
  std::vector<double> squares(columns);
  Envelope envelope(columns);
  for (std::size_t row = 0; row < rows; ++row) {
    envelope.run(away.data() + row * columns, columns, squares.data());
    for (std::size_t q = 0; q < columns; ++q) {
      field.cells[row * columns + q] =
          static_cast<float>(occupied.geometry.resolution * std::sqrt(squares[q]));
    }
  }
  return field;
}

}  // namespace eyebridge::mapping
