#pragma once

#include <cstdint>

#include "eyebridge/base/random.hpp"
#include "eyebridge/world/world.hpp"

namespace eyebridge::world {

/// An object that moves by itself, and not on a path.
struct Reactor {
  BodyId body = kNoBody;
  Reaction reaction;
  double yields_within = 0.0;  ///< As in ObjectSpec.
  Random random;               ///< Of this object alone.
  Vec2 direction{};            ///< Unit vector in which it wanders.
  std::uint64_t bounces = 0;   ///< How often that has changed: how far `random` is.
};

}  // namespace eyebridge::world
