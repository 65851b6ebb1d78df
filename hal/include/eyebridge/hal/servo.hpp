#pragma once

#include "eyebridge/base/result.hpp"

namespace eyebridge::hal {

/// One servo.
class Servo {
 public:
  virtual ~Servo() = default;

  /// `position` 0 … 1; 0.5 is the middle.
  virtual Result<void> set(double position) = 0;
};

}  // namespace eyebridge::hal
