#pragma once

#include <optional>

#include "eyebridge/hal/environment.hpp"

namespace eyebridge::gui {

/// What the mouse has taken hold of: a robot or a thing by its middle, to be carried, or a robot by
/// its rim, to be turned.
struct Grip {
  world::BodyId body = 0;
  std::optional<std::size_t> robot{};  ///< Its index; nothing for a thing.
  std::size_t object = 0;              ///< Of a thing: its number, from 0.
  Pose start;                          ///< Of the body, when it was taken.
  Vec2 hold;                           ///< Where, in the world.
  bool turns = false;

  friend bool operator==(const Grip&, const Grip&) = default;
};

/// Share of the radius beyond which the mouse takes hold of the rim: a third of the way is left.
inline constexpr double kRimShare = 0.67;

/// What lies under `place`; `slack`, metres, is how far beside it one may point. Nothing there:
/// nothing.
std::optional<Grip> grip_at(const hal::WorldLook& look, Vec2 place, double slack);

/// Where the body belongs when the mouse has come to `place`.
Pose moved(const Grip& grip, Vec2 place);

}  // namespace eyebridge::gui
