#pragma once

#include <string>

#include "eyebridge/files/scenario.hpp"

namespace CLI {
class App;
}

namespace eyebridge::apps {

/// `world list`: the worlds that can be named, by the place that they come from.
void add_world_list(CLI::App& world, int& code);

/// "4 m x 4 m", of a maze with its cells: ", 5 x 5 cells of 0.36 m".
std::string size_text(const files::Scenario& scenario);

/// "2 robots and 1 that enter later".
std::string robots_text(const files::Scenario& scenario);

}  // namespace eyebridge::apps
