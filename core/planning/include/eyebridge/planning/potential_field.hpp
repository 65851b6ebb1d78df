#pragma once

#include "eyebridge/planning/clearance.hpp"

namespace eyebridge::planning {

struct PotentialSettings {
  double attraction = 1.0;  ///< Pull of the goal, 1/m^2 of potential, > 0.
  double bowl = 1.0;  ///< Beyond this distance from the goal it pulls no stronger, metres, > 0.
  double repulsion = 0.02;  ///< Push of obstacles, m^2 of potential, >= 0.
  double reach = 0.5;       ///< Farther obstacles do not push, metres, > 0.
  int steps = 20000;        ///< Of half a cell each, at most, > 0.
};

/// The way that a point takes which the goal draws and obstacles push, from `start`, metres, to
/// `goal`: no search, and no promise. Where pull and push cancel out before the goal it says
/// LocalMinimum: in pockets, before walls across the way, or if obstacles stand too near the goal.
/// What it returns is free of blocked cells. Throws std::invalid_argument for settings out of
/// range.
///
/// Khatib, "Real-Time Obstacle Avoidance for Manipulators and Mobile Robots", International Journal
/// of Robotics Research 5 (1986); the pull is constant beyond the bowl, as in Latombe, "Robot
/// Motion Planning" (1991), section 7.1. `clearance` is clearance_of(blocked).
Planned follow_potential(const BlockedRaster& blocked, const ClearanceRaster& clearance, Vec2 start,
                         Vec2 goal, const PotentialSettings& settings = {});

}  // namespace eyebridge::planning
