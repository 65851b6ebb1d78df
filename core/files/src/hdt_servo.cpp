#include <algorithm>
#include <cmath>

#include "eyebridge/files/hdt.hpp"

namespace eyebridge::files {

ServoLimits servo_limits(const HdtServo& servo) {
  const auto tens = [](double seconds) {
    return std::clamp(static_cast<int>(std::lround(seconds * 1e5)), 0, 255);
  };
  return {tens(servo.shortest_pulse), tens(servo.longest_pulse)};
}

}  // namespace eyebridge::files
