#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "eyebridge/base/pose.hpp"

namespace eyebridge::camera {
struct Frame;
}

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

/// A marker in a picture.
struct SeenMarker {
  int id = 0;
  std::array<Vec2, 4> corners{};  ///< Of its black square, in turn; pixels.
};

/// What a person who carries a robot's camera wants to know at one moment.
struct HandLook {
  Instruction instruction;
  /// Whether markers tell where the robot is: without, what follows is empty.
  bool has_markers = false;
  std::optional<Pose> pose;  ///< Of the robot in the world; none while it is lost.
  /// Of that pose's x, y and heading, row by row: m^2, m rad, rad^2. As the finder's filter has it:
  /// from the scatter of the markers' corners, growing while none is seen.
  std::array<double, 9> covariance{};
  std::shared_ptr<const camera::Frame> frame;  ///< The camera's last one; null before.
  std::vector<SeenMarker> markers;             ///< In that frame, whether or not they are used.
};

/// Guides the person who carries a robot. Owned by the backend; any thread.
class HandGuide {
 public:
  virtual ~HandGuide() = default;
  /// Waits for no frame, and changes nothing.
  [[nodiscard]] virtual HandLook look() const = 0;
};

}  // namespace eyebridge::hal
