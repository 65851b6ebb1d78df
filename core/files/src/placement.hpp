#pragma once

#include <optional>
#include <string>

#include "eyebridge/files/scenario.hpp"

namespace eyebridge::files {

/// What a disc of `radius` metres at `centre` would touch in `scenario`: a wall, an object or a
/// robot placed already, in words; nothing when the place is free. Rims may touch.
std::optional<std::string> obstacle_at(const Scenario& scenario, Vec2 centre, double radius);

/// The free place on the floor nearest to its centre (in a maze: a cell's centre).
std::optional<Vec2> free_place(const Scenario& scenario, double radius);

}  // namespace eyebridge::files
