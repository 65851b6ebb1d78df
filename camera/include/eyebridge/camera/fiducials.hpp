#pragma once

#include <vector>

#include "eyebridge/base/pose.hpp"
#include "eyebridge/world/world_model.hpp"

namespace eyebridge::camera {

/// A square black-and-white mark on a wall, by whose picture a camera knows where it is.
struct Fiducial {
  int id = 0;           ///< Its number in the dictionary.
  Vec2 centre;          ///< On the wall's face, world, metres.
  double z = 0.0;       ///< Of its centre above the floor, metres.
  double facing = 0.0;  ///< Heading of the normal, away from the wall, radians.
  double size = 0.0;    ///< Edge of its black square, metres.

  friend bool operator==(const Fiducial&, const Fiducial&) = default;
};

/// How a world is marked.
struct FiducialLayout {
  double size = 0.08;     ///< Edge of the black square, metres; smaller where a wall is too small.
  double spacing = 0.36;  ///< On longer walls one for so many metres.
  double height = 0.0;    ///< Of the centres above the floor, metres; 0: the middle of the wall.

  friend bool operator==(const FiducialLayout&, const FiducialLayout&) = default;
};

/// Where the fiducials of a world are: on each face of each wall that can be seen from inside the
/// world, in the order of the walls, numbered from 0. The same world and layout always give the
/// same: the sheet that was printed and the program that looks at it need no file between them.
/// Throws ConfigError when the world needs more than the dictionary has.
std::vector<Fiducial> place_fiducials(const world::WorldModel& model,
                                      const FiducialLayout& layout = {});

}  // namespace eyebridge::camera
