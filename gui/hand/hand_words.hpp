#pragma once

#include <QString>

#include "eyebridge/camera/sign.hpp"
#include "eyebridge/hal/hand_guide.hpp"

namespace eyebridge::gui {

/// What the sign shows.
struct HandWords {
  camera::Arrow arrow = camera::Arrow::None;
  QString headline;  ///< "420 mm": how far still; where there is no goal, how fast.
  QString detail;    ///< "Straight ahead", or why the robot is lost.
  QString speed;     ///< "200 mm/s", where the headline is something else.

  friend bool operator==(const HandWords&, const HandWords&) = default;
};

HandWords words_for(const hal::Instruction& instruction);

}  // namespace eyebridge::gui
