#pragma once

#include <cstdint>
#include <vector>

#include "geometry.hpp"
#include "segment_grid.hpp"

namespace eyebridge::world {

/// Joins walls that lie on one line, have one thickness and touch, so that a disc that drives along
/// them meets no joints. Colours and heights are lost: for collision only.
std::vector<Wall> join_collinear(const std::vector<Wall>& walls);

/// The walls as discs meet them, in a uniform grid. Immutable after construction.
class WallIndex {
 public:
  explicit WallIndex(const std::vector<Wall>& walls);

  /// What a disc meets, and how far away the walls are at all.
  struct Approach {
    double fraction = kNoContact;
    std::uint32_t segment = 0;  ///< First one met; valid when fraction <= 1.
    double distance = 0.0;      ///< From the start to the nearest wall, or `horizon` if farther.
  };
  /// First wall that a disc's centre comes within `reach` of, on the way from `from` along
  /// `motion`, `length` metres. Walls farther than `horizon` >= reach + length are not looked at.
  [[nodiscard]] Approach approach(Vec2 from, Vec2 motion, double length, double reach,
                                  double horizon) const;

  /// Distance from `p` to the nearest outline where that is less than `limit`, else `limit`.
  [[nodiscard]] double distance(Vec2 p, double limit) const;

  /// True when `p` lies in a thick wall.
  [[nodiscard]] bool inside_thick(Vec2 p) const;

  /// Calls visit(segment index, distance) for each segment nearer than `limit`, at least once.
  template <class Visit>
  void each_near(Vec2 p, double limit, Visit visit) const {
    grid_.each_in_box({p.x - limit, p.y - limit}, {p.x + limit, p.y + limit}, [&](std::uint32_t i) {
      const double d = norm(p - closest_point(segments_[i], p));
      if (d < limit) visit(i, d);
    });
  }

  [[nodiscard]] const std::vector<Segment>& segments() const { return segments_; }

 private:
  std::vector<Wall> joined_;           ///< The walls, joined.
  std::vector<Segment> segments_;      ///< Their outlines.
  std::vector<std::uint32_t> owners_;  ///< Index into joined_ of each segment's wall.
  SegmentGrid grid_;
  std::vector<std::uint32_t> thick_;  ///< Indices into joined_ of the walls with a thickness.
  double thickest_ = 0.0;             ///< Metres.
  SegmentGrid axes_;                  ///< Of the thick ones.
};

}  // namespace eyebridge::world
