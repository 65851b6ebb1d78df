#pragma once

#include <string>

#include "eyebridge/camera/frame.hpp"

namespace eyebridge::camera {

/// What is drawn on a sign.
enum class Arrow {
  None,  ///< A bar: stand still.
  Forward,
  Backward,
  TurnLeft,
  TurnRight,
  CurveLeft,  ///< Forward and to the left.
  CurveRight,
  BackLeft,  ///< Backward and to the left.
  BackRight,
  Lost,  ///< A question mark.
};

/// The arrow of a movement: how far along, and how far to turn, each in whatever unit; forward and
/// counter-clockwise are positive.
Arrow arrow_for(double along, double turn);

/// A big plain picture for a person who walks: which way, and two lines of words.
struct Sign {
  Arrow arrow = Arrow::None;
  std::string headline;  ///< "0.42 m"; about ten letters have room.
  std::string detail;    ///< "forward, 0.20 m/s"; about thirty.

  friend bool operator==(const Sign&, const Sign&) = default;
};

/// The sign as a picture, 4 : 3, the longest side of `longest_side` pixels. Rgb24.
Frame draw_sign(const Sign& sign, int longest_side = 640);

}  // namespace eyebridge::camera
