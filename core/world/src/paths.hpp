#pragma once

#include <vector>

#include "eyebridge/world/world.hpp"

namespace eyebridge::world {

/// An object that moves by itself, on a way of straight legs.
struct Mover {
  BodyId body = kNoBody;
  double speed = 0.0;       ///< Metres per second.
  bool loop = true;         ///< Else there and back.
  std::vector<Vec2> stops;  ///< Its first place, then the way-points.
  std::size_t target = 1;   ///< Index of the stop that it heads for.
  bool forward = true;      ///< Whether the stops come in their order; in a loop always.

  /// Heads for the stop after the one that was reached.
  void turn_to_next();
};

}  // namespace eyebridge::world
