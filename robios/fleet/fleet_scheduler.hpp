#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "fleet.hpp"

namespace eyebridge::robios {

/// Who lets robots run: one after the other in virtual time, or each by itself.
struct Fleet::Scheduler {
  virtual ~Scheduler() = default;
  /// For the world; null in real time.
  virtual hal::Turns* turns() = 0;
  /// So many robots will have a program, and so many will enter later: before the first one.
  virtual void expect(std::size_t programs, std::size_t newcomers) = 0;
  virtual std::unique_ptr<Robot> make(std::size_t index, RobotProgram program,
                                      hal::SharedWorld& world) = 0;
  /// The next robot of the world, in the order of their numbers, from `start` on; null for one
  /// without a program.
  virtual void add(Robot* robot, Time start) = 0;
  /// Lets `robot`, which entered while the others run, run, too.
  virtual void start_late(Robot& robot) = 0;
  /// Lets those of the start run, and all that enter later, to the end.
  virtual void run(Fleet& fleet, const std::vector<Robot*>& robots) = 0;
  /// Fleet::add().
  virtual Result<std::size_t> let_in(Fleet& fleet, hal::Newcomer newcomer) = 0;
  /// Fleet::remove(): its index again.
  virtual Result<std::size_t> let_out(Fleet& fleet, std::size_t index) = 0;
  /// Called ten times a second from a thread of ours.
  virtual void look() = 0;
};

}  // namespace eyebridge::robios
