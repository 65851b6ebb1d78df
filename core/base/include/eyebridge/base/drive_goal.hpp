#pragma once

namespace eyebridge {

/// A movement that ends by itself. `distance` and `angle` may both be given: an arc.
struct DriveGoal {
  double distance = 0.0;  ///< Along the path, metres; negative drives backwards.
  double angle = 0.0;     ///< Total change of heading, radians; positive is counter-clockwise.
  double speed = 0.0;     ///< Magnitude: metres per second, or radians per second for a turn on the
                          ///< spot (distance 0).
};

}  // namespace eyebridge
