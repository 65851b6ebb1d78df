#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "eyebridge/base/pose.hpp"

namespace eyebridge::camera {

/// The nearest wall in every direction before an eye, seen from above.
///
/// Points are (depth along the eye's heading, sideways to the left), metres; a direction is u, the
/// tangent of its bearing: sideways / depth. On a line, 1 / depth is linear in u, so the nearest
/// walls are the upper envelope of straight pieces over u, which is kept exactly: walls may cross.
class Horizon {
 public:
  /// Opens all directions -`reach` … `reach`; what is nearer than `nearest` will hide nothing.
  void clear(double reach, double nearest);

  /// Puts the wall from `a` to `b`, known as `wall`, into the picture.
  void add(Vec2 a, Vec2 b, std::uint32_t wall);

  /// True when in every direction that the hull of `corners` spans a wall stands nearer than all of
  /// them. False when one of them is nearer than `nearest`.
  [[nodiscard]] bool hides(std::span<const Vec2> corners) const;

  [[nodiscard]] double nearest() const { return nearest_; }

  /// Depth of the farthest wall that is seen, metres; infinite while a direction is open.
  [[nodiscard]] double farthest() const;

  /// Appends the walls that are seen somewhere; some may come more than once.
  void list_seen(std::vector<std::uint32_t>& walls) const;

 private:
  /// A segment: 1 / depth at a direction.
  struct Line {
    double u = 0.0;        ///< A direction.
    double inverse = 0.0;  ///< 1 / depth there; 0 is open.
    double slope = 0.0;    ///< Of 1 / depth, over u.
    std::uint32_t wall = 0;

    [[nodiscard]] double at(double direction) const { return inverse + slope * (direction - u); }
  };
  /// What is seen from `from` to where the next piece begins.
  struct Piece {
    double from;
    Line line;
  };

  [[nodiscard]] std::size_t piece_at(double u) const;
  [[nodiscard]] double end_of(std::size_t piece) const {
    return piece + 1 < pieces_.size() ? pieces_[piece + 1].from : reach_;
  }
  void put(double from, const Line& line);

  double reach_ = 1.0;
  double nearest_ = 0.0;
  std::vector<Piece> pieces_;           ///< Ordered; the last ends at reach_.
  std::vector<Piece> changed_;          ///< While adding.
  std::vector<std::uint32_t> as_near_;  ///< Walls that lie in the plane of one that is seen.
};

}  // namespace eyebridge::camera
