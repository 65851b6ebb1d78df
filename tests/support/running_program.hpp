#pragma once

#include <string>

#include <sys/types.h>

#include "eyebridge/base/unique_fd.hpp"
#include "run_program.hpp"

namespace eyebridge::testing {

/// A program that runs beside the test; killed at the end unless it was waited for. May be made in
/// any thread; each object is one thread's.
class RunningProgram {
 public:
  /// Throws std::runtime_error when it cannot be started.
  explicit RunningProgram(const ProgramStart& start);
  ~RunningProgram();
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  /// Standard output and standard error up to and with `text`; all that came when it did not come
  /// within two minutes of silence.
  const std::string& wait_for(const std::string& text);
  [[nodiscard]] pid_t pid() const { return pid_; }
  /// Sends `signal`, returns at once.
  void signal(int signal) const;
  /// Waits for its end; kills it when it says nothing for two minutes. What was said until then is
  /// in said(). Returns the exit code, or 128 + the signal that ended it.
  int wait();
  /// signal() and wait().
  int finish(int signal);
  /// What was read so far of both outputs.
  [[nodiscard]] const std::string& said() const { return said_; }

 private:
  bool read_more();

  UniqueFd out_;
  pid_t pid_ = -1;
  std::string said_;
};

}  // namespace eyebridge::testing
