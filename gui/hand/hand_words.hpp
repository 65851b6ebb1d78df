#pragma once

#include <QString>

#include "eyebridge/hal/hand_guide.hpp"

namespace eyebridge::gui {

/// Which way a person is to go.
enum class Way {
  Stand,
  Forward,
  Backward,
  TurnLeft,
  TurnRight,
  CurveLeft,  ///< Forward and to the left.
  CurveRight,
  BackLeft,  ///< Backward and to the left.
  BackRight,
  Lost,
};

/// What the sign shows.
struct HandWords {
  Way way = Way::Stand;
  QString headline;  ///< "420 mm": how far still; where there is no goal, how fast.
  QString detail;    ///< "Straight ahead", or why the robot is lost.
  QString speed;     ///< "200 mm/s", where the headline is something else.

  friend bool operator==(const HandWords&, const HandWords&) = default;
};

HandWords words_for(const hal::Instruction& instruction);

}  // namespace eyebridge::gui
