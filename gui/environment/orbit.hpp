#pragma once

#include "eyebridge/base/units.hpp"
#include "eyebridge/camera/view.hpp"

namespace eyebridge::gui {

/// An eye that looks at a place on the floor from around it.
struct Orbit {
  static constexpr double kNearest = 0.1;   ///< Metres.
  static constexpr double kFarthest = 500;  ///< Metres.

  Vec2 target;                     ///< Of the optical axis, on the floor.
  double distance = 3.0;           ///< Of the eye from there, metres.
  double heading = kPi / 2;        ///< Of the optical axis, radians counter-clockwise from +x.
  double height = deg_to_rad(40);  ///< Of the eye above the floor as seen from the target, radians.

  /// So that a floor from (0, 0) to `extent` can be seen, from its lower side.
  static Orbit of_floor(Vec2 near, Vec2 far);
  /// Behind a robot and above it.
  static Orbit behind(const Pose& robot);

  [[nodiscard]] camera::Eye eye() const;
  /// Radians; the eye stays above the floor and does not go over the top.
  void turn(double around, double up);
  /// Nearer (below 1) or farther.
  void move_away(double factor);
  /// Along the floor, metres to the right of the picture and into it.
  void shift(double right, double ahead);
};

}  // namespace eyebridge::gui
