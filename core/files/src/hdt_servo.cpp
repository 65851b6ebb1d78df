#include <algorithm>
#include <cmath>

#include "eyebridge/files/hdt.hpp"

namespace eyebridge::files {

ServoLimits servo_limits(const HdtServo& servo) {
  const auto tens = [](double seconds) {
    return static_cast<int>(std::lround(std::clamp(seconds * 1e5, 0.0, 255.0)));
  };
  return {tens(servo.shortest_pulse), tens(servo.longest_pulse)};
}

}  // namespace eyebridge::files
