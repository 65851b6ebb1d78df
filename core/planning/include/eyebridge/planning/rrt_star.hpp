#pragma once

#include "eyebridge/base/random.hpp"
#include "eyebridge/planning/path.hpp"

namespace eyebridge::planning {

struct RrtStarSettings {
  int samples = 4000;       ///< Points drawn, > 0. More make paths shorter, and the search longer.
  double step = 0.5;        ///< Longest line that is grown at once, metres, > 0.
  double goal_bias = 0.05;  ///< How often the goal itself is drawn, (0, 1].
};

/// A way from `start` to `goal`, metres, through points drawn evenly from the free cells; it starts
/// and ends in these very points. With ever more samples its length tends to the shortest there is;
/// for a given number no bound is promised: shortened() takes the corners out of it. It proves no
/// absence: where it finds nothing it says BudgetSpent. All samples are used. Same seed, same path.
/// Throws std::invalid_argument for settings out of range.
///
/// Karaman and Frazzoli, "Sampling-based algorithms for optimal motion planning", International
/// Journal of Robotics Research 30 (2011), algorithm 6, with its bound for the radius of rewiring.
Planned rrt_star(const BlockedRaster& blocked, Vec2 start, Vec2 goal, Random& random,
                 const RrtStarSettings& settings = {});

}  // namespace eyebridge::planning
