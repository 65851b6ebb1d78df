#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "bodies.hpp"

namespace eyebridge::world {

/// One body, as rays meet it.
struct Disc {
  double x, y;    ///< Centre, metres.
  double radius;  ///< Metres.
  BodyId id;
};

/// A copy of all discs, boxes and polygons left out, sorted by place: for rays, which look far and
/// in all directions.
///
/// Made anew when somebody looks after a body has moved, so that many looks between two steps
/// share it. Cells hold a few bodies each, those of a row follow each other in memory.
class BodyMap {
 public:
  /// So many places beyond a run of Rows may be read.
  static constexpr std::size_t kBeyond = 8;
  /// The place of a body that is not in the map.
  static constexpr std::uint32_t kNowhere = ~std::uint32_t{0};

  explicit BodyMap(double width, double height) : extent_{width, height} {}

  /// Brings the copy up to date.
  void refresh(const Bodies& bodies);

  /// The bodies whose centres are less than `reach` metres from `place`, in no order. Valid until
  /// the next call.
  [[nodiscard]] std::span<const Disc> around(Vec2 place, double reach);

  /// The discs in the order of the map, and nearly the same in single precision, in a row each.
  /// kBeyond more than there are may be read: no ray meets those.
  struct Rows {
    const Disc* discs;
    const float* x;
    const float* y;
    const float* radius;
    std::uint32_t nobody;  ///< The first one that no ray meets.
  };
  /// Cells of the map: those of a row follow each other in `Rows`.
  struct Box {
    std::size_t first, last;  ///< Columns.
    std::size_t first_row, last_row;
  };
  /// The cells that hold all discs with centres between two corners, and more.
  [[nodiscard]] Box box(Vec2 low, Vec2 high) const {
    // Places outside belong to the rim, also on this side of it.
    return {column_of(low.x), column_of(high.x), row_of(low.y), row_of(high.y)};
  }
  /// How the floor is divided: cells a metre, and the last ones.
  struct Cells {
    double per_column, per_row;
    double last_column, last_row;
  };
  [[nodiscard]] Cells cells() const {
    return {per_column_, per_row_, static_cast<double>(columns_ - 1),
            static_cast<double>(rows_ - 1)};
  }
  [[nodiscard]] std::size_t begin_of(const Box& box, std::size_t row) const {
    return starts_[row * columns_ + box.first];
  }
  [[nodiscard]] std::size_t end_of(const Box& box, std::size_t row) const {
    return starts_[row * columns_ + box.last + 1];
  }
  /// While it lives no ray meets the body in `Rows`. kNoBody is ignored. Looks that come at once
  /// would wait for what it writes.
  class Hidden {
   public:
    Hidden(BodyMap& map, BodyId id)
        : radius_(id < map.places_.size() ? &map.r_[map.places_[id]] : &none_),
          was_(std::exchange(*radius_, std::numeric_limits<float>::quiet_NaN())) {}
    ~Hidden() { *radius_ = was_; }
    Hidden(const Hidden&) = delete;
    Hidden& operator=(const Hidden&) = delete;

   private:
    float none_ = 0.0F;
    float* radius_;
    float was_;
  };
  /// Where the body is in `Rows`; beyond all of them where it is not.
  [[nodiscard]] std::uint32_t place_of(BodyId id) const {
    return id < places_.size() ? places_[id] : kNowhere;
  }
  [[nodiscard]] Rows rows() const {
    return {discs_.data(), x_.data(), y_.data(), r_.data(), starts_.back()};
  }
  /// Metres by which the floats of `Rows` may be off, seen from `place`.
  [[nodiscard]] double error(Vec2 place) const {
    return 1e-4 + 1e-6 * (farthest_ + std::fabs(place.x) + std::fabs(place.y));
  }

 private:
  [[nodiscard]] std::uint32_t where_nobody_is() const {
    return static_cast<std::uint32_t>(ids_.size() + kBeyond - 1);
  }
  [[nodiscard]] std::size_t column_of(double x) const { return index(x * per_column_, columns_); }
  [[nodiscard]] std::size_t row_of(double y) const { return index(y * per_row_, rows_); }
  static std::size_t index(double i, std::size_t count) {
    const auto last = static_cast<double>(static_cast<std::int64_t>(count) - 1);
    const double low = i > 0.0 ? i : 0.0;
    const double within = low < last ? low : last;
    return static_cast<std::size_t>(static_cast<std::int64_t>(within));  // fewer steps than at once
  }

  Vec2 extent_;
  std::uint64_t version_ = 0;  ///< Of the bodies.
  double per_column_ = 1.0;
  double per_row_ = 1.0;
  std::size_t columns_ = 1;
  std::size_t rows_ = 1;
  std::vector<std::uint32_t> starts_{0, 0};  ///< Cell -> first of its discs; one more at the end.
  std::vector<Disc> discs_;
  std::vector<BodyId> ids_;            ///< All discs, removed ones too.
  std::vector<std::uint32_t> places_;  ///< Body -> its disc, among `discs_`.
  std::vector<float> x_, y_, r_;
  double farthest_ = 0.0;   ///< Of all coordinates, metres.
  std::vector<Disc> near_;  ///< Of around(); room for all.
};

}  // namespace eyebridge::world
