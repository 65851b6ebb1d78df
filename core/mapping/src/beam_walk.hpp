#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "eyebridge/base/pose.hpp"

namespace eyebridge::mapping {

/// The cells of a box that a beam goes through: one in each column (of a steep beam: in each row),
/// counted by `k` from the beam's origin, whose own cell is 0. Places are in cells from the box's
/// lower left corner.
///
/// A digital differential analyser; the other coordinate is a fixed-point number with 32 bits of
/// fraction, so that a step is one addition, without rounding that adds up over a beam's cells by
/// more than 2^-20 of one.
class BeamWalk {
 public:
  /// `direction` is a unit vector, `origin` within 2^24 cells of the box.
  BeamWalk(Vec2 origin, Vec2 direction) : steep_(std::abs(direction.y) > std::abs(direction.x)) {
    const double along = steep_ ? origin.y : origin.x;
    const double across = steep_ ? origin.x : origin.y;
    const double major = steep_ ? direction.y : direction.x;
    const double minor = steep_ ? direction.x : direction.y;
    step_ = major < 0.0 ? -1 : 1;
    share_ = std::abs(major);
    const double slope = minor / share_;
    const double cell = std::floor(along);
    first_ = static_cast<std::int64_t>(cell);
    offset_ = step_ > 0 ? cell + 0.5 - along : along - cell - 0.5;
    slope_ = static_cast<std::int64_t>(slope * kOne);
    across_ = static_cast<std::int64_t>(std::floor((across + offset_ * slope) * kOne));
  }

  /// Share of a length along the beam that it makes along its columns, 0.7 … 1.
  [[nodiscard]] double share() const { return share_; }
  /// Distance along the columns from the origin to the middle of that of cell `k`.
  [[nodiscard]] double distance(int k) const { return offset_ + k; }
  /// The first cell whose middle is at least `distance` away.
  [[nodiscard]] int first_at(double distance) const {
    return static_cast<int>(std::ceil(distance - offset_));
  }

  /// Narrows `from` … `to` (not counted) to cells within a box of this size.
  void clip(int columns, int rows, int& from, int& to) const;

  /// Calls visit(index in a box with `columns`) for the cells `from` … `to`, which lie within it.
  template <class Visit>
  void visit(int columns, int from, int to, Visit&& visit) const {
    std::int64_t across = across_ + from * slope_;
    if (steep_) {
      std::ptrdiff_t row = (first_ + step_ * std::int64_t{from}) * columns;
      const std::ptrdiff_t up = step_ * std::ptrdiff_t{columns};
      for (int k = from; k < to; ++k, row += up, across += slope_) {
        visit(static_cast<std::size_t>(row + (across >> kBits)), k);
      }
    } else {
      std::ptrdiff_t column = first_ + step_ * std::int64_t{from};
      for (int k = from; k < to; ++k, column += step_, across += slope_) {
        visit(static_cast<std::size_t>((across >> kBits) * columns + column), k);
      }
    }
  }

 private:
  static constexpr int kBits = 32;
  static constexpr double kOne = 4294967296.0;

  bool steep_;
  int step_ = 1;
  double share_ = 1.0;
  double offset_ = 0.0;
  std::int64_t first_ = 0;
  std::int64_t slope_ = 0;
  std::int64_t across_ = 0;
};

}  // namespace eyebridge::mapping
