#pragma once

#include <string>

#include <sys/types.h>

#include "eyebridge/base/unique_fd.hpp"
#include "run_program.hpp"

namespace eyebridge::testing {

/// A program that runs beside the test; killed at the end unless it was finished before.
class RunningProgram {
 public:
  /// Standard error is the test's own.
  explicit RunningProgram(const ProgramStart& start);
  ~RunningProgram();
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  /// Standard output up to and with `text`; what there is when a minute passes, or it ends.
  std::string wait_for(const std::string& text);
  /// Sends `signal` and returns the exit code, or 128 + the signal that ended it.
  int finish(int signal);
  [[nodiscard]] pid_t id() const { return pid_; }

 private:
  UniqueFd out_;
  pid_t pid_ = -1;
  std::string said_;
};

}  // namespace eyebridge::testing
