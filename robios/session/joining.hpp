#pragma once

#include <memory>

#include "eyebridge/hal/config.hpp"
#include "eyebridge/hal/shared_world.hpp"
#include "eyebridge/hal/turns.hpp"
#include "windows/windows.hpp"

namespace eyebridge::robios {

/// Robots that join the world of a process's only robot while its program runs. Nothing but a look
/// at each step in virtual time, and the run's control socket, as long as there are none.
class Joining : public Crew {
 public:
  /// For the world, before it is there.
  virtual hal::JoiningTurns& turns() = 0;
  /// The first robot is in its world, null where none can join: lets others join from now on.
  virtual void open(std::shared_ptr<hal::SharedWorld> world) = 0;
  /// Ten times a second, in a thread of ours.
  virtual void look() = 0;
  /// True while a program of these robots runs. Any thread.
  [[nodiscard]] virtual bool is_busy() const = 0;
  /// True while all robots wait for one of these programs, in virtual time. Any thread.
  [[nodiscard]] virtual bool is_awaited() const = 0;
  /// The first robot's program has ended: lets the others run to their ends. Their first exit code
  /// that is not 0. Again does nothing more.
  virtual int await_end() = 0;
  /// Ends all their programs, before a signal ends the process: await_end() does not return then.
  virtual void end() noexcept = 0;
};

/// Defined by robios/fleet. `config`: of a session in a simulated world.
std::unique_ptr<Joining> make_joining(const hal::Config& config);

}  // namespace eyebridge::robios
