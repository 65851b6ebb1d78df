#pragma once

#include <array>
#include <memory>

namespace eyebridge::robios {

/// From now on a robot whose program crashes (bad memory access, illegal instruction, division by
/// zero, abort()) ends alone, with a message. A crash while it had locked the world, or in no
/// robot's program, ends the process as ever.
void handle_crashes();

/// Makes the robot that runs in `thread` end, as a crash would, when it is not inside a call of
/// ours. Any thread.
void interrupt_robot(unsigned long thread);

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
