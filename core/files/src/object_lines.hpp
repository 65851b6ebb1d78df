#pragma once

#include "eyebridge/files/readers.hpp"
#include "text.hpp"

namespace eyebridge::files {

/// The keywords of lines that say how the object of the line before them behaves.
bool is_object_trait(std::string_view keyword);

/// Reads "mass KG", "friction MU", "restitution E", "fixed" or "path MM_PER_SECOND loop|back x1 y1
/// [x2 y2 ...]" into `traits`, and the lines of motion_lines.hpp. Throws ConfigError for numbers
/// that cannot be.
void read_object_trait(const Statement& s, ObjectTraits& traits);

/// The same into `object`, which may have some of them.
ObjectTraits read_more(const Statement& s, world::ObjectSpec& object);

/// What `traits` say, said of `object`.
void apply(const ObjectTraits& traits, world::ObjectSpec& object);

/// What a box or polygon is like whose line says no more than its size.
inline constexpr double kBoxHeight = 0.2;  ///< Metres.
inline constexpr Rgb kBoxColour{150, 110, 60};
inline constexpr double kBoxMass = 1.0;  ///< Kilograms.

/// What stands for an object whose file cannot be read: a fixed box of this length and width.
inline constexpr double kStandInSize = 0.1;  ///< Metres.
world::ObjectSpec standing_box(const std::string& name);

/// Our own "box x y phi length width [height [red green blue]]". Throws ConfigError.
world::ObjectSpec read_box(const Statement& s, const Pose& pose);

/// Our own "polygon x y phi x1 y1 x2 y2 x3 y3 ... [height MM] [colour R G B]"; otherwise it is like
/// a box. Its corners may go round either way. Throws ConfigError.
world::ObjectSpec read_polygon(const Statement& s, const Pose& pose);

}  // namespace eyebridge::files
