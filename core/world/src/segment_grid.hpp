#pragma once

#include <cstdint>
#include <vector>

#include "geometry.hpp"

namespace eyebridge::world {

/// Which segments cross which cell of a uniform grid. Immutable after construction.
///
/// A segment on the border of two cells is listed in both, one that misses a cell by less than a
/// ten-millionth of its size too, so that rounding loses none.
class SegmentGrid {
 public:
  /// Cells of about `cell` metres over the segments' bounding box; the edge length grows where
  /// there would be more than about 16 cells a segment. `ring` more cells lie around the box.
  SegmentGrid(const std::vector<Segment>& segments, double cell, std::size_t ring);

  [[nodiscard]] bool empty() const { return items_.empty(); }
  [[nodiscard]] Vec2 origin() const { return origin_; }  ///< Lower left of cell 0.
  [[nodiscard]] double cell() const { return cell_; }    ///< Edge length, metres.
  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] std::size_t rows() const { return rows_; }

  [[nodiscard]] std::size_t column_of(double x) const { return index(x - origin_.x, columns_); }
  [[nodiscard]] std::size_t row_of(double y) const { return index(y - origin_.y, rows_); }

  /// Indices of the segments in cell row * columns() + column, ascending.
  [[nodiscard]] const std::uint32_t* begin_of(std::size_t cell) const {
    return items_.data() + starts_[cell];
  }
  [[nodiscard]] const std::uint32_t* end_of(std::size_t cell) const { return begin_of(cell + 1); }

  /// Calls visit(segment index) for the segments of all cells that the box touches; one that lies
  /// in several cells comes several times.
  template <class Visit>
  void each_in_box(Vec2 low, Vec2 high, Visit visit) const {
    const std::size_t first = column_of(low.x);
    const std::size_t last = column_of(high.x);
    const std::size_t last_row = row_of(high.y);
    for (std::size_t row = row_of(low.y); row <= last_row; ++row) {
      // Cells of a row follow each other, and so do their lists.
      const std::uint32_t* const end = end_of(row * columns_ + last);
      for (const std::uint32_t* i = begin_of(row * columns_ + first); i != end; ++i) visit(*i);
    }
  }

 private:
  /// Places outside belong to the outermost cells; so do NaNs.
  [[nodiscard]] std::size_t index(double offset, std::size_t count) const {
    const double i = offset * per_cell_;
    if (!(i > 0.0)) return 0;
    return i < static_cast<double>(count) ? static_cast<std::size_t>(i) : count - 1;
  }
  template <class Visit>
  void each_cell_of(const Segment& segment, Visit visit) const;

  Vec2 origin_;
  double cell_ = 1.0;
  double per_cell_ = 1.0;
  std::size_t columns_ = 1;
  std::size_t rows_ = 1;
  std::vector<std::uint32_t> starts_{0, 0};  ///< Cell -> first of its items; one more at the end.
  std::vector<std::uint32_t> items_;
};

/// Edge length of cells that hold about `segments_per_cell` segments' lengths each, metres.
double cell_size_for(const std::vector<Segment>& segments, double segments_per_cell);

}  // namespace eyebridge::world
