#pragma once

#include <functional>
#include <string>

namespace eyebridge::robios {

/// What a thread waits for in the kernel.
struct ThreadWait {
  std::string call;  ///< "read()"; "a call of the system" where it cannot be told.
  bool is_at_terminal = false;
};

/// Reads the `text` of proc(5), /proc/PID/task/TID/syscall; `is_terminal` is asked about a
/// descriptor of that process.
ThreadWait read_thread_wait(const char* text, const std::function<bool(int)>& is_terminal);

/// A look at the thread `tid` of process `pid`; some 10 microseconds.
ThreadWait look_at_wait(int pid, int tid);

}  // namespace eyebridge::robios
