#pragma once

#include <cstdint>
#include <vector>

#include "geometry.hpp"

namespace eyebridge::world {

/// Joins walls that lie on one line, have one thickness and touch, so that a disc that drives along
/// them meets no joints. Colours and heights are lost: for collision only.
std::vector<Wall> join_collinear(const std::vector<Wall>& walls);

/// The walls as discs meet them, in a uniform grid. Immutable after construction.
class WallIndex {
 public:
  explicit WallIndex(const std::vector<Wall>& walls);

  struct Contact {
    double fraction = kNoContact;
    std::uint32_t segment = 0;  ///< Valid when fraction <= 1.
  };
  /// First wall that a disc's centre comes within `reach` of, on the way from `from` along
  /// `motion`.
  [[nodiscard]] Contact first_contact(Vec2 from, Vec2 motion, double reach) const;

  /// Distance from `p` to the nearest outline where that is less than `limit`, else `limit`.
  [[nodiscard]] double distance(Vec2 p, double limit) const;

  /// True when `p` lies in a thick wall.
  [[nodiscard]] bool inside_thick(Vec2 p) const;

  /// Calls visit(segment index, distance) for each segment nearer than `limit`, at least once.
  template <class Visit>
  void each_near(Vec2 p, double limit, Visit visit) const {
    each_in_box({p.x - limit, p.y - limit}, {p.x + limit, p.y + limit}, [&](std::uint32_t i) {
      const double d = norm(p - closest_point(segments_[i], p));
      if (d < limit) visit(i, d);
    });
  }

  [[nodiscard]] const std::vector<Segment>& segments() const { return segments_; }

 private:
  struct Range {
    std::size_t first;
    std::size_t last;
  };
  [[nodiscard]] Range columns_of(double x0, double x1) const {
    return {cell_of(x0 - origin_.x, columns_), cell_of(x1 - origin_.x, columns_)};
  }
  [[nodiscard]] Range rows_of(double y0, double y1) const {
    return {cell_of(y0 - origin_.y, rows_), cell_of(y1 - origin_.y, rows_)};
  }
  /// Places outside belong to the outermost cells; so do NaNs.
  [[nodiscard]] std::size_t cell_of(double offset, std::size_t count) const {
    const double index = offset * per_cell_;
    if (!(index > 0.0)) return 0;
    return index < static_cast<double>(count) ? static_cast<std::size_t>(index) : count - 1;
  }
  /// Calls visit(segment index) for the segments of all cells that the box touches; one that lies
  /// in several cells comes several times.
  template <class Visit>
  void each_in_box(Vec2 low, Vec2 high, Visit visit) const {
    if (segments_.empty()) return;
    const Range columns = columns_of(low.x, high.x);
    const Range rows = rows_of(low.y, high.y);
    for (std::size_t row = rows.first; row <= rows.last; ++row) {
      const std::size_t base = row * columns_;
      // Cells of a row follow each other, and so do their lists.
      const std::uint32_t end = starts_[base + columns.last + 1];
      for (std::uint32_t k = starts_[base + columns.first]; k < end; ++k) visit(items_[k]);
    }
  }
  void build_grid();

  std::vector<Segment> segments_;
  std::vector<Wall> thick_;            ///< Walls with a thickness.
  std::vector<std::uint32_t> owners_;  ///< Index into thick_ of each segment, or kBare.
  std::vector<std::uint32_t> starts_;  ///< Cell -> first of its items; one more at the end.
  std::vector<std::uint32_t> items_;
  Vec2 origin_;
  double per_cell_ = 1.0;  ///< 1 / edge length of a cell.
  std::size_t columns_ = 1;
  std::size_t rows_ = 1;
};

}  // namespace eyebridge::world
