#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "bodies.hpp"

namespace eyebridge::world {

/// One body, as rays meet it.
struct Disc {
  double x, y;    ///< Centre, metres.
  double radius;  ///< Metres.
  BodyId id;
};

/// A copy of all discs, sorted by place: for rays, which look far and in all directions.
///
/// Made anew when somebody looks after a body has moved, so that many looks between two steps
/// share it. Cells hold a few bodies each, those of a row follow each other in memory.
class BodyMap {
 public:
  /// So many places beyond a run of Rows may be read.
  static constexpr std::size_t kBeyond = 8;

  explicit BodyMap(double width, double height) : extent_{width, height} {}

  /// Brings the copy up to date.
  void refresh(const Bodies& bodies);

  /// The bodies whose centres are less than `reach` metres from `place`, in no order. Valid until
  /// the next call.
  [[nodiscard]] std::span<const Disc> around(Vec2 place, double reach);

  /// The discs in the order of the map, and nearly the same in single precision, in a row each; as
  /// many more as a register holds may be read.
  struct Rows {
    const Disc* discs;
    const float* x;
    const float* y;
    const float* radius;
    double error;  ///< Metres by which the floats may be off, seen from `place`.
  };
  /// Calls visit(begin, end) for runs of `Rows` that hold all discs that around() would find, and
  /// more.
  template <class Visit>
  void each_run(Vec2 place, double reach, Visit visit) const {
    // Places outside belong to the rim, also on this side of it.
    const std::size_t first = index(place.x - reach, columns_);
    const std::size_t last = index(place.x + reach, columns_);
    const std::size_t last_row = index(place.y + reach, rows_);
    for (std::size_t row = index(place.y - reach, rows_); row <= last_row; ++row) {
      const std::size_t begin = starts_[row * columns_ + first];
      const std::size_t end = starts_[row * columns_ + last + 1];
      if (begin < end) visit(begin, end);
    }
  }
  [[nodiscard]] Rows rows(Vec2 place) const {
    const double size = farthest_ + std::fabs(place.x) + std::fabs(place.y);
    return {discs_.data(), x_.data(), y_.data(), r_.data(), 1e-4 + 1e-6 * size};
  }

 private:
  [[nodiscard]] std::size_t index(double coordinate, std::size_t count) const {
    const double i = coordinate * per_cell_;
    if (!(i > 0.0)) return 0;
    return i < static_cast<double>(count) ? static_cast<std::size_t>(i) : count - 1;
  }

  Vec2 extent_;
  std::uint64_t version_ = 0;  ///< Of the bodies.
  double per_cell_ = 1.0;
  std::size_t columns_ = 1;
  std::size_t rows_ = 1;
  std::vector<std::uint32_t> starts_;  ///< Cell -> first of its discs; one more at the end.
  std::vector<Disc> discs_;
  std::vector<std::uint32_t> cells_;  ///< Body -> its cell.
  std::vector<float> x_, y_, r_;
  double farthest_ = 0.0;   ///< Of all coordinates, metres.
  std::vector<Disc> near_;  ///< Of around(); room for all.
};

}  // namespace eyebridge::world
