#pragma once

#include <array>
#include <memory>

namespace eyebridge::robios {

class Robot;

/// From now on a crash of a robot's program (bad memory access, illegal instruction, division by
/// zero, a corrupt heap) ends the run, with a message: the other robots share its memory and its
/// locks, so they cannot go on. If the program has a handler for the signal, that is called
/// instead.
void handle_crashes();

/// The robot whose program has crashed: the run is to be ended, before the process is soon. Null
/// while all is well. Any thread.
[[nodiscard]] Robot* broken_robot();

/// A program has a handler of its own for `signal`: it runs on the program's stack, as it would in
/// a process of its own. Nothing where the signal is no crash.
void let_program_handle(int signal);

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
};

}  // namespace eyebridge::robios
