#pragma once

#include "eyebridge/world/world_model.hpp"

namespace eyebridge::files {

/// Makes the floor of `model` the smallest one that has all of its walls and starts. False, and
/// nothing is changed, where those span no floor.
bool floor_around(world::WorldModel& model);

}  // namespace eyebridge::files
