#pragma once

#include <vector>

#include "eyebridge/base/pose.hpp"

namespace eyebridge::planning {

/// How far along a path a robot is, and what lies ahead. It only moves on, so that a path may cross
/// itself. Not thread-safe.
class PathProgress {
 public:
  /// Way-points with straight lines between them, metres; at least one, else it throws
  /// std::invalid_argument.
  explicit PathProgress(std::vector<Vec2> points);

  /// Moves on to the place of the path nearest to `position` among those at most `window` metres
  /// ahead, of equally near ones the first.
  void advance(Vec2 position, double window);

  /// Metres along the path, from its start.
  [[nodiscard]] double done() const { return done_; }
  /// Metres along the path, to its end.
  [[nodiscard]] double remaining() const { return starts_.back() - done_; }
  [[nodiscard]] Vec2 end() const { return points_.back(); }

  /// The place `distance` metres ahead along the path, or its end.
  [[nodiscard]] Vec2 ahead(double distance) const;

  /// The first place ahead that is `distance` metres away from `position` in a straight line; the
  /// place reached so far if that is farther away already, the end if the path never gets so far.
  [[nodiscard]] Vec2 leaving_circle(Vec2 position, double distance) const;

 private:
  /// Line from way-point i to the next, or the only point; `along` is counted from the path's
  /// start.
  [[nodiscard]] std::size_t line_at(double along) const;
  [[nodiscard]] Vec2 at(double along) const;

  std::vector<Vec2> points_;
  std::vector<double> starts_;  ///< Of each way-point, along the path.
  double done_ = 0.0;
};

}  // namespace eyebridge::planning
