#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "eyebridge/base/clock.hpp"
#include "eyebridge/base/pose.hpp"

namespace eyebridge::hal {

/// Notices a robot that stays on its spot and turns to the same few headings again and again.
///
/// Without errors a robot repeats a turn to the last bit, so that a program which looks for a
/// better reading may never find one. Costs nothing between commands. Not thread-safe.
class Repeats {
 public:
  /// Each command to the drive: `now` and where the robot is then. Says once how many headings
  /// there are: when the robot has stayed on one spot for a minute, has turned to no new heading,
  /// and to each known one at least twice. A pause of 20 s between two turns begins the minute
  /// anew.
  std::optional<std::size_t> add(Time now, const Pose& pose);

 private:
  struct Heading {
    double theta = 0.0;
    unsigned visits = 0;  ///< Turns to it since since_.
  };
  void begin(Time now);

  Vec2 spot_;
  std::vector<Heading> headings_;
  std::size_t present_ = 0;  ///< Index of the heading at the last command.
  Time since_{};             ///< When the minute began.
  Time turned_{};            ///< When the last turn was seen.
  bool has_told_ = false;
};

}  // namespace eyebridge::hal
