#pragma once

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
  explicit BodyMap(double width, double height) : extent_{width, height} {}

  /// Brings the copy up to date.
  void refresh(const Bodies& bodies);

  /// The bodies whose centres are less than `reach` metres from `place`, in no order. Valid until
  /// the next call.
  [[nodiscard]] std::span<const Disc> around(Vec2 place, double reach);

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
  std::vector<Disc> near_;            ///< Of around(); room for all.
};

}  // namespace eyebridge::world
