#pragma once

#include <string>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/camera/sign.hpp"
#include "eyebridge/hal/hand_guide.hpp"

namespace eyebridge::hal {

/// In words, for a line of text: "forward 0.42 m at 0.20 m/s", "turn left 85 deg at 45 deg/s".
std::string in_words(const Instruction& instruction);
/// As a sign.
camera::Sign as_sign(const Instruction& instruction);

/// Who shows instructions to the person. Any thread.
class InstructionSink {
 public:
  virtual ~InstructionSink() = default;
  /// `now` on the robot's clock. Called with every frame, and with every command.
  virtual void show(Time now, const Instruction& instruction) = 0;
  /// The run has ended: what was last to be shown is, and nothing any more. May come again.
  virtual void finish() = 0;
};

}  // namespace eyebridge::hal
