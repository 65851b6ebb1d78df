#pragma once

#include <string>
#include <vector>

#include "eyebridge/files/map_files.hpp"
#include "eyebridge/world/world_model.hpp"

namespace eyebridge::files {

/// A map as a world: walls around what is occupied, at the map's own places. A robot starts where
/// it has most room, near the middle. `file` is for messages. Throws ConfigError.
world::WorldModel world_of(const MapFiles& map, const std::string& file,
                           std::vector<Warning>& warnings);

}  // namespace eyebridge::files
