#pragma once

#include <memory>

#include "eyebridge/world/ray_caster.hpp"
#include "eyebridge/world/world_model.hpp"
#include "near_walls.hpp"
#include "wall_index.hpp"

namespace eyebridge::world {

/// What never changes in a world: made once for all worlds of a model. A thousand worlds then share
/// one copy in the processor's cache, and a new episode builds nothing. Any thread.
struct StandingWalls {
  explicit StandingWalls(std::shared_ptr<const WorldModel> world_model);

  /// The one that other worlds of `model` have, or a new one.
  static std::shared_ptr<const StandingWalls> of(std::shared_ptr<const WorldModel> model);

  std::shared_ptr<const WorldModel> model;
  WallIndex index;
  RayCaster rays;
  bool by_sweep;  ///< Rays meet walls by `near` where few are near; else by `rays` alone.
  NearWalls near;
};

}  // namespace eyebridge::world
