#pragma once

namespace CLI {
class App;
}

namespace eyebridge::apps {

/// `world convert`: a world or maze in another format.
void add_world_convert(CLI::App& world, int& code);

}  // namespace eyebridge::apps
