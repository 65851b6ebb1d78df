#pragma once

#include <span>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/pose.hpp"

namespace eyebridge::hal {

/// What a robot did and saw at one moment.
struct TracePoint {
  Time time{0};
  Pose pose;      ///< Truth, in the world; on a board the same as `odometry`.
  Twist twist;    ///< As driven.
  Pose odometry;  ///< As the robot believes.
  std::span<const double>
      ranges;  ///< Of all distance sensors in order of id, metres; lent for the call.
};

/// Takes the trace of a run. Called from the thread that steps the world; must not call the
/// backend.
class TraceSink {
 public:
  virtual ~TraceSink() = default;
  virtual void point(const TracePoint& point) noexcept = 0;
};

}  // namespace eyebridge::hal
