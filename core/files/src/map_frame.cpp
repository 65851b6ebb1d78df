#include "map_frame.hpp"

#include <algorithm>
#include <cmath>

namespace eyebridge::files {

MapFrame::MapFrame(const MapDescription& map, int columns, int rows)
    : origin_(map.origin),
      resolution_(map.resolution),
      columns_(columns),
      rows_(rows),
      is_turned_(map.yaw != 0.0) {
  const Heading heading = Heading::from_angle(map.yaw);
  right_ = heading.forward();
  up_ = {-right_.y, right_.x};
  if (!is_turned_) {
    right_ = {1, 0};
    up_ = {0, 1};
  }
  low_ = high_ = origin_;
  for (const Vec2 corner : {place(0, 0), place(columns, 0), place(columns, rows)}) {
    low_ = {std::min(low_.x, corner.x), std::min(low_.y, corner.y)};
    high_ = {std::max(high_.x, corner.x), std::max(high_.y, corner.y)};
  }
}

Vec2 MapFrame::place(double x, double y) const {
  return origin_ + x * resolution_ * right_ + (rows_ - y) * resolution_ * up_;
}

mapping::GridGeometry MapFrame::covering() const {
  if (!is_turned_) return {origin_, resolution_, columns_, rows_};
  // A quarter turn that is written with four decimals makes no cell more.
  constexpr double kSlack = 0.05;  // of a cell
  const auto cells = [this](double length) {
    return std::max(static_cast<int>(std::ceil(length / resolution_ - kSlack)), 1);
  };
  return {low_, resolution_, cells(high_.x - low_.x), cells(high_.y - low_.y)};
}

std::optional<std::size_t> MapFrame::pixel_at(const mapping::GridGeometry& geometry,
                                              mapping::Cell cell) const {
  const auto index = [this](int column, int row) {
    return static_cast<std::size_t>(rows_ - 1 - row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  };
  if (!is_turned_) return index(cell.column, cell.row);
  const Vec2 from_origin = geometry.centre_of(cell) - origin_;
  const double column = std::floor(dot(from_origin, right_) / resolution_);
  const double row = std::floor(dot(from_origin, up_) / resolution_);
  if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return std::nullopt;
  return index(static_cast<int>(column), static_cast<int>(row));
}

}  // namespace eyebridge::files
