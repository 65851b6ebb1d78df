#pragma once

#include <string>
#include <string_view>

#include "eyebridge/files/load.hpp"

namespace eyebridge::files {

/// Walls around 2 m x 2 m.
world::WorldModel empty_room();

/// Fills `scenario` from the `.sim` file `name` with content `text`. Throws ConfigError.
void load_sim(std::string_view text, const std::string& name, const SearchPlaces& places,
              Scenario& scenario);

}  // namespace eyebridge::files
