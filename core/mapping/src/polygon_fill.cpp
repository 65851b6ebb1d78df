#include "polygon_fill.hpp"

#include <algorithm>

namespace eyebridge::mapping {
namespace {

/// The first cell along an axis whose middle is beyond `place`, cut to 0 … count.
inline std::int32_t first_beyond(double place, double count) {
  const double whole = place + 0.5;
  const double least = whole > 0.0 ? whole : 0.0;
  const double cut = least < count ? least : count;
  return static_cast<std::int32_t>(cut);
}

}  // namespace

void PolygonFill::begin(const Box& box) {
  box_ = box;
  words_ = box.stride / kBits;
  const std::size_t size = box.size() / kBits;
  if (flips_.size() < size) flips_.resize(size, 0);
  lowest_ = box.rows;
  highest_ = 0;
}

void PolygonFill::flip(Vec2 origin, std::span<const float> x, std::span<const float> y, bool open) {
  const std::size_t count = x.size();
  if (count == 0) return;
  rows_.resize(count);
  const double rows = box_.rows;
  for (std::size_t i = 0; i < count; ++i) rows_[i] = first_beyond(origin.y + y[i], rows);
  const auto corner = [&](std::size_t i) { return origin + Vec2{x[i], y[i]}; };
  // Some edges cross the middle of a row, nobody knows which: a list without branches is faster.
  crossing_.resize(count);
  std::size_t crossings = 0;
  for (std::size_t i = 1; i < count; ++i) {
    crossing_[crossings] = i;
    crossings += rows_[i] != rows_[i - 1] ? 1 : 0;
  }
  for (std::size_t c = 0; c < crossings; ++c) {
    const std::size_t i = crossing_[c];
    edge(corner(i - 1), rows_[i - 1], corner(i), rows_[i]);
  }
  const std::size_t last = count - 1;
  if (open) {
    const std::int32_t row = first_beyond(origin.y, rows);
    edge(corner(last), rows_[last], origin, row);
    edge(origin, row, corner(0), rows_[0]);
  } else {
    edge(corner(last), rows_[last], corner(0), rows_[0]);
  }
}

void PolygonFill::edge(Vec2 from, std::int32_t from_row, Vec2 to, std::int32_t to_row) {
  if (from_row > to_row) {
    std::swap(from, to);
    std::swap(from_row, to_row);
  }
  lowest_ = std::min(lowest_, from_row);
  highest_ = std::max(highest_, to_row);
  const double slope = (to.x - from.x) / (to.y - from.y);
  for (std::int32_t row = from_row; row < to_row; ++row) {
    const double x = from.x + (row + 0.5 - from.y) * slope;
    const std::int32_t column = first_beyond(x, box_.columns);
    // A flip beyond the last column is of no cell, and there may be no room for it.
    if (column == box_.columns) continue;
    const auto word = static_cast<std::size_t>(row * words_ + column / kBits);
    flips_[word] ^= std::uint64_t{1} << (column % kBits);
  }
}

}  // namespace eyebridge::mapping
