#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "eyebridge/base/pose.hpp"

namespace eyebridge::mapping {

/// The whole number below or at `x`, |x| < 2^62; std::floor is a call without SSE 4.1.
inline std::int64_t whole_below(double x) {
  const auto cut = static_cast<std::int64_t>(x);
  return cut - (static_cast<double>(cut) > x ? 1 : 0);
}

/// A part of a grid, with a buffer for it.
struct Box {
  int columns = 0;
  int rows = 0;
  int stride = 0;  ///< Of rows in the buffer.

  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(rows) * static_cast<std::size_t>(stride);
  }
  /// The place of a cell; size() for one outside.
  [[nodiscard]] std::size_t index_of(std::int64_t column, std::int64_t row) const {
    if (column < 0 || row < 0 || column >= columns || row >= rows) return size();
    return static_cast<std::size_t>(row * stride + column);
  }
};

/// Where beams begin: what all of them have in common. Places are in cells from the box's lower
/// left corner.
class BeamStart {
 public:
  /// `origin` lies within 2^24 cells of the box.
  explicit BeamStart(Vec2 origin) : x_(origin.x), y_(origin.y) {}

 private:
  friend class BeamWalk;
  struct Axis {
    explicit Axis(double place) : at(place), cell(whole_below(place)) {
      const auto begin = static_cast<double>(cell);
      up = begin + 0.5 - at;
      down = at - begin - 0.5;
    }
    double at;
    std::int64_t cell;
    double up;  // from there to the middle of its cell, for beams to either side
    double down;
  };
  Axis x_;
  Axis y_;
};

/// The cells of a box that a beam goes through: one in each column (of a steep beam: in each row),
/// counted by `k` from the beam's origin, whose own cell is 0.
///
/// A digital differential analyser; the other coordinate is a fixed-point number with 32 bits of
/// fraction, so that a step is one addition, without rounding that adds up over a beam's cells by
/// more than 2^-20 of one.
class BeamWalk {
 public:
  /// `direction` is a unit vector.
  BeamWalk(const BeamStart& start, Vec2 direction)
      : steep_(std::abs(direction.y) > std::abs(direction.x)) {
    const BeamStart::Axis& along = steep_ ? start.y_ : start.x_;
    const BeamStart::Axis& across = steep_ ? start.x_ : start.y_;
    const double major = steep_ ? direction.y : direction.x;
    const double minor = steep_ ? direction.x : direction.y;
    step_ = major < 0.0 ? -1 : 1;
    share_ = std::abs(major);
    first_ = along.cell;
    offset_ = step_ > 0 ? along.up : along.down;
    const double slope = minor / share_ * kOne;
    slope_ = static_cast<std::int64_t>(slope);
    across_ = whole_below(across.at * kOne + offset_ * slope);
  }

  /// Share of a length along the beam that it makes along its columns, 0.7 … 1.
  [[nodiscard]] double share() const { return share_; }
  /// Distance along the columns from the origin to the middle of that of cell `k`.
  [[nodiscard]] double distance(int k) const { return offset_ + k; }
  /// The first cell whose middle is at least `distance` away.
  [[nodiscard]] int first_at(double distance) const {
    return -static_cast<int>(whole_below(offset_ - distance));
  }

  /// Index in `box` of the cell in the column of cell `k` that the beam is in at `distance` along
  /// the columns; the box's size where that is outside.
  [[nodiscard]] std::size_t index_at(int k, double distance, const Box& box) const {
    const std::int64_t along = first_ + step_ * std::int64_t{k};
    const auto moved =
        static_cast<std::int64_t>((distance - offset_) * static_cast<double>(slope_));
    const std::int64_t across = (across_ + moved) >> kBits;
    return steep_ ? box.index_of(across, along) : box.index_of(along, across);
  }

  /// Narrows `from` … `to` (not counted) to cells within `box`.
  void clip(const Box& box, int& from, int& to) const;

  /// Calls visit(index in `box`, k) for the cells `from` … `to` (not counted), which lie within it.
  template <class Visit>
  void visit(const Box& box, int from, int to, Visit&& visit) const {
    if (from >= to) return;
    // Copies: else what `visit` writes makes the compiler read them again for every cell.
    const std::int64_t slope = slope_;
    const std::int64_t stride = box.stride;
    const std::int64_t step = steep_ ? step_ * stride : step_;
    const std::int64_t first = first_ + step_ * std::int64_t{from};
    std::int64_t along = steep_ ? first * stride : first;
    std::int64_t across = across_ + from * slope;
    if (steep_) {
      for (int k = from; k < to; ++k, along += step, across += slope) {
        visit(static_cast<std::size_t>(along + (across >> kBits)), k);
      }
    } else {
      for (int k = from; k < to; ++k, along += step, across += slope) {
        visit(static_cast<std::size_t>(along + (across >> kBits) * stride), k);
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
