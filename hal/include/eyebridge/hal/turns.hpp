#pragma once

#include <atomic>
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

  /// Where the clock of `robot` (an index) may not get by itself: the end of the round. It
  /// changes; the reference stays.
  [[nodiscard]] virtual const Time& limit_of(std::size_t robot) const = 0;
  /// Called by a robot that goes on at `time` >= its limit: returns when it may.
  virtual void wait(std::size_t robot, Time time) = 0;
};

/// The turns of robots that join a robot which began alone, in virtual time. That robot's own
/// threads make the steps: they call the two functions here, one thread at a time.
class JoiningTurns : public Turns {
 public:
  /// False while no robot has joined or wants to: then a step needs no call of what follows.
  [[nodiscard]] bool has_any() const { return count_.load(std::memory_order_relaxed) != 0; }
  /// The world is about to make the step that ends at `end`: returns when all other robots have
  /// come that far.
  virtual void before_step(Time end) = 0;
  /// The world has made a step: robots may enter or leave now.
  virtual void after_step() = 0;

 protected:
  /// Robots whose programs run, and requests to let one in or out.
  std::atomic<std::size_t> count_ = 0;
};

}  // namespace eyebridge::hal
