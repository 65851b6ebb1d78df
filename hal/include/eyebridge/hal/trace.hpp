#pragma once

#include <span>
#include <string_view>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/pose.hpp"

namespace eyebridge::hal {

/// What a robot did and saw at one moment.
struct TracePoint {
  Time time{0};   ///< Of the robot's clock.
  Pose pose;      ///< Truth, in the world, metres and radians; on a board the same as `odometry`.
  Twist twist;    ///< As driven, metres and radians per second.
  Pose odometry;  ///< As the robot believes.
  std::span<const double>
      ranges;  ///< Of all distance sensors in order of id, metres; lent for the call.
};

/// Something that the robot ran into, or that ran into it: told of once, when they began to touch.
struct TraceContact {
  Time time{0};            ///< Of the robot's clock.
  std::string_view robot;  ///< "robot 1": as the log calls it.
  std::string_view with;   ///< "wall", "robot 2" or "object 3".
  Vec2 place;              ///< In the world, metres.
};

/// Takes the trace of a run. Called from the thread that steps the world, which may be another one
/// each time, but never two at once; must not call the backend.
class TraceSink {
 public:
  virtual ~TraceSink() = default;
  /// One step. A sink that cannot take it (a full disk) says so when it is asked, later: nobody
  /// listens during a step.
  virtual void point(const TracePoint& point) noexcept = 0;
  /// Whether more than the pose of a point at `time` will be used: readings take a while.
  [[nodiscard]] virtual bool is_due(Time /*time*/) const noexcept { return true; }
  /// A contact, before the point of its step. Who does not care lets it pass.
  virtual void contact(const TraceContact&) noexcept {}
};

}  // namespace eyebridge::hal
