#pragma once

#include <string>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/pose.hpp"
#include "eyebridge/camera/sign.hpp"

namespace eyebridge::hal {

/// What the person who carries a robot is to do now. Metres, radians, seconds.
struct Instruction {
  enum class Kind {
    Stand,
    Speed,  ///< Move at `speed` until the next instruction.
    Goal,   ///< `distance` and `angle` are still to go, at `speed`, which has no sign.
    Lost,   ///< Nobody knows where the robot is.
  };

  Kind kind = Kind::Stand;
  double distance = 0.0;  ///< Negative is backward.
  double angle = 0.0;     ///< Of a curve or a turn; counter-clockwise is positive.
  Twist speed;
  std::string reason;  ///< Of Lost.
  int command = 0;     ///< How many commands the program has given so far.
};

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
