#pragma once

#include <array>
#include <memory>

#include "library_locks.hpp"

namespace eyebridge::robios {

class Robot;

/// From now on a robot whose program crashes (bad memory access, illegal instruction, division by
/// zero, abort()) ends alone, with a message. A crash while it had locked the world, or in no
/// robot's program, ends the process as ever. `are_threads`: robots run beside each other.
void handle_crashes(bool are_threads);

/// The robot whose program has ended in the middle of a function of the C library, so that the
/// others cannot go on: the run is to be ended, before the process is soon. Null while all is well.
/// Any thread.
[[nodiscard]] Robot* broken_robot();

/// Makes the robot that runs in `thread` end, as a crash would, in its program: what it waits for
/// is interrupted, and a call of ours or the C library's returns first. Again and again, by one
/// thread.
void interrupt_robot(unsigned long thread);
/// True when an interrupted robot's program has not returned to its own code yet.
[[nodiscard]] bool is_outside_program();

/// The calling thread's room for the handler: a program that used up its stack has none left.
class CrashStack {
 public:
  CrashStack();
  ~CrashStack();
  CrashStack(const CrashStack&) = delete;
  CrashStack& operator=(const CrashStack&) = delete;

 private:
  static constexpr std::size_t kSize = 64 * 1024;
  std::unique_ptr<std::array<char, kSize>> room_;
  const library_locks::HeapInUse heap_;
};

}  // namespace eyebridge::robios
