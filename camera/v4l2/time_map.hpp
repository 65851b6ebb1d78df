#pragma once

#include <algorithm>

#include "eyebridge/base/clock.hpp"

namespace eyebridge::camera {

/// The robot's time of moments on CLOCK_MONOTONIC. The robot's clock may run at another rate, which
/// shows between two looks at both.
class TimeMap {
 public:
  /// The robot's time of `moment`, now that both clocks show `monotonic` and `robot`. Never after
  /// `robot`, never before an earlier answer.
  Time to_robot(Time moment, Time monotonic, Time robot) {
    // The rate shows soon, and then more and more exactly: spans that are too short would make a
    // rate of the noise of two readings.
    const Time least = std::chrono::milliseconds(is_measured_ ? 1000 : 20);
    if (!looked_) {
      looked_ = true;
      monotonic_ = monotonic;
      robot_ = robot;
    } else if (monotonic - monotonic_ >= least) {
      rate_ = static_cast<double>((robot - robot_).count()) /
              static_cast<double>((monotonic - monotonic_).count());
      is_measured_ = true;
      monotonic_ = monotonic;
      robot_ = robot;
    }
    const auto age = static_cast<double>((monotonic - moment).count());
    last_ = std::clamp(robot - Time(static_cast<Time::rep>(age * rate_)), std::min(last_, robot),
                       robot);
    return last_;
  }

 private:
  bool looked_ = false;
  bool is_measured_ = false;
  Time monotonic_{0};
  Time robot_{0};
  double rate_ = 1.0;
  Time last_{0};
};

}  // namespace eyebridge::camera
