#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "eyebridge/files/scenario.hpp"

namespace eyebridge::files {

/// A wall as a box on the floor, metres.
struct WallBox {
  Pose pose;  ///< Of its middle, x along the wall.
  double length = 0.0;
  double thickness = 0.0;  ///< A bare wall's: kBareThickness.
};
/// Where every wall needs a thickness, a bare one has this, metres.
inline constexpr double kBareThickness = 0.001;

WallBox box_of(const world::Wall& wall);

/// `text` between tags or in quotes of XML; characters that XML cannot have are '?'.
std::string xml_text(std::string_view text);

/// Where a scenario's robots stand, and the starts where none does.
std::vector<Pose> places_of_robots(const Scenario& scenario);

/// What hardly any format of others can say of a world: its texture, water, markers, the goals of a
/// maze, robots, and bare walls where those have a thickness.
enum class BareWalls { Stay, BecomeThin };
std::vector<std::string> common_losses(const Scenario& scenario, BareWalls bare);

/// Adds "1 wall ..." or "3 walls ..." if `count` is not 0: `what` in the singular, `rest` after it.
void add_loss(std::vector<std::string>& losses, std::size_t count, std::string_view what,
              std::string_view rest = {});

}  // namespace eyebridge::files
