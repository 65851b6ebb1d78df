#include "segment_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace eyebridge::world {
namespace {

struct Box {
  Vec2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec2 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  [[nodiscard]] double extent() const { return std::max(high.x - low.x, high.y - low.y); }
  /// Never 0, also when all walls lie on one line.
  [[nodiscard]] double area() const {
    return std::max((high.x - low.x) * (high.y - low.y), 1e-6 * extent() * extent());
  }
};

Box bounds_of(const std::vector<Segment>& segments) {
  Box box;
  for (const Segment& s : segments) {
    for (const Vec2 p : {s.a, s.a + s.length * s.u}) {
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
  }
  return box;
}

double length_of(const std::vector<Segment>& segments) {
  double length = 0.0;
  for (const Segment& s : segments) length += s.length;
  return length;
}

}  // namespace

double cell_size_for(const std::vector<Segment>& segments, double segments_per_cell) {
  if (segments.empty()) return 1.0;
  const double length = length_of(segments);
  // A cell of edge c is crossed by about (total length / area) * c^2 / c pieces of its size.
  return segments_per_cell * bounds_of(segments).area() / length;
}

template <class Visit>
void SegmentGrid::each_cell_of(const Segment& segment, Visit visit) const {
  const double slack = 1e-7 * cell_;
  const double width = cell_ * static_cast<double>(columns_);
  const Vec2 end = segment.a + segment.length * segment.u;
  const std::size_t first = column_of(std::min(segment.a.x, end.x) - slack);
  const std::size_t last = column_of(std::max(segment.a.x, end.x) + slack);
  const std::size_t last_row = row_of(std::max(segment.a.y, end.y) + slack);
  // Half the extent of a cell across the segment's direction.
  const double half = (cell_ / 2) * (std::fabs(segment.u.x) + std::fabs(segment.u.y)) + slack;
  for (std::size_t row = row_of(std::min(segment.a.y, end.y) - slack); row <= last_row; ++row) {
    // Where the row can meet that band: a long diagonal segment has few cells in its box.
    std::size_t begin = first;
    std::size_t end_column = last;
    const double y = origin_.y + cell_ * (static_cast<double>(row) + 0.5) - segment.a.y;
    if (std::fabs(segment.u.y) * width > cell_) {
      const double middle = segment.a.x + segment.u.x * y / segment.u.y;
      const double reach = half / std::fabs(segment.u.y) + cell_;
      begin = std::max(first, column_of(middle - reach));
      end_column = std::min(last, column_of(middle + reach));
    }
    for (std::size_t column = begin; column <= end_column; ++column) {
      const Vec2 centre =
          origin_ + cell_ * Vec2{static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5};
      if (std::fabs(cross(segment.u, centre - segment.a)) <= half) visit(row * columns_ + column);
    }
  }
}

SegmentGrid::SegmentGrid(const std::vector<Segment>& segments, double cell, std::size_t ring) {
  if (segments.empty()) return;
  const Box box = bounds_of(segments);
  const double most = 16.0 * static_cast<double>(segments.size()) + 64.0;
  // A segment is listed in at most 1.5 times as many cells as it is long, and a few: thousands that
  // lie on one another would need gigabytes.
  constexpr double kMostItems = 2e6;
  cell_ = std::max({cell, std::sqrt(box.area() / most), box.extent() / 2048,
                    1.5 * length_of(segments) / kMostItems});
  per_cell_ = 1.0 / cell_;
  const auto count = [&](double extent) {
    return static_cast<std::size_t>(extent * per_cell_) + 1 + 2 * ring;
  };
  columns_ = count(box.high.x - box.low.x);
  rows_ = count(box.high.y - box.low.y);
  const double margin = static_cast<double>(ring) * cell_;
  origin_ = box.low - Vec2{margin, margin};

  starts_.assign(columns_ * rows_ + 1, 0);
  for (const Segment& s : segments) each_cell_of(s, [&](std::size_t c) { ++starts_[c + 1]; });
  for (std::size_t c = 1; c < starts_.size(); ++c) starts_[c] += starts_[c - 1];
  items_.resize(starts_.back());
  std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    each_cell_of(segments[i], [&](std::size_t c) { items_[next[c]++] = i; });
  }
}

}  // namespace eyebridge::world
