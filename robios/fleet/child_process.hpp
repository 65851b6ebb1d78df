#pragma once

#include <string>
#include <vector>

#include <sys/types.h>

#include "eyebridge/base/unique_fd.hpp"

namespace eyebridge::robios {

/// A process that this one starts, and that does not outlive it.
class ChildProcess {
 public:
  /// Starts `words` (a program, found in PATH when its name has no slash, and its arguments) with
  /// the variables `environment`; it has `descriptor` besides standard input and output, and Ctrl-C
  /// does not reach it. It ends at the latest with the calling thread. Throws std::system_error
  /// when the system refuses.
  ChildProcess(const std::vector<std::string>& words, const std::vector<std::string>& environment,
               int descriptor);
  /// Kills it unless wait() has returned.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Becomes readable when it ends: for poll().
  [[nodiscard]] int descriptor() const { return life_.get(); }
  /// True when it has ended, now or within `seconds`. Any thread.
  [[nodiscard]] bool ends_within(double seconds) const;
  /// Does nothing once it has ended. Any thread.
  void signal(int signal) const;
  [[nodiscard]] pid_t pid() const { return pid_; }
  /// Waits for its end; its status as of waitpid(). Once.
  int wait();
  /// Lets the system forget it, if it has ended: for who cannot wait for wait(), whose status may
  /// be lost then. Any thread.
  void forget() const;
  /// Of the processor, seconds so far; 0 once it has ended. Any thread.
  [[nodiscard]] double processor_time() const;

 private:
  pid_t pid_ = -1;
  UniqueFd life_;
  bool is_over_ = false;
};

}  // namespace eyebridge::robios
