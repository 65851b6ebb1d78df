#pragma once

#include <cstddef>

#include "eyebridge/base/clock.hpp"

namespace eyebridge::hal {

/// Who decides which of several robots runs, in virtual time. One thread at a time.
///
/// Time of the world passes in rounds of one step. Within a round each robot runs by itself, in a
/// fixed order, until it wants to go beyond the round's end; when all do, the world makes its step.
class Turns {
 public:
  virtual ~Turns() = default;

  /// Where the clock of `robot` (an index) may not get by itself: the end of the round, or the
  /// time of another of its threads. It changes; the reference stays.
  [[nodiscard]] virtual const Time& limit_of(std::size_t robot) const = 0;
  /// Called by a robot that goes on at `time` >= its limit: returns when it may.
  virtual void wait(std::size_t robot, Time time) = 0;
};

}  // namespace eyebridge::hal
