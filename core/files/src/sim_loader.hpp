#pragma once

#include <string>
#include <string_view>

#include "eyebridge/files/load.hpp"

namespace eyebridge::files {

/// Walls around 2 m x 2 m.
world::WorldModel empty_room();

/// Adds a robot. Throws ConfigError at `where` when something stands there already.
void place(Scenario& scenario, std::size_t model, const Pose& pose, const SourceLocation& where);
/// Adds a robot at the free place nearest to the centre of the floor.
void place_anywhere(Scenario& scenario, std::size_t model, const SourceLocation& where);
/// Adds `robot` to the models and places one at the world's first start, else anywhere.
void place_at_start(Scenario& scenario, const robot::RobotModel& robot,
                    const SourceLocation& where);

/// Fills `scenario` from the `.sim` file `name` with content `text`. Throws ConfigError.
void load_sim(std::string_view text, const std::string& name, const SearchPlaces& places,
              Scenario& scenario);

}  // namespace eyebridge::files
