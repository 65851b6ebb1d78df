#pragma once

#include <string>
#include <vector>

#include <sys/types.h>

#include "eyebridge/base/pose.hpp"

namespace eyebridge::testing {

/// `eyebridge firmware` in a process of its own, with one board in a world.
class FirmwareProcess {
 public:
  /// Returns when the board listens. Fails the test otherwise.
  explicit FirmwareProcess(const std::vector<std::string>& options);
  ~FirmwareProcess();
  FirmwareProcess(const FirmwareProcess&) = delete;
  FirmwareProcess& operator=(const FirmwareProcess&) = delete;

  /// What `--hal` must be to reach the board, by its own word.
  [[nodiscard]] const std::string& hal() const { return hal_; }
  [[nodiscard]] pid_t pid() const { return pid_; }
  /// Ends the process as Ctrl-C does; where the robot really is then: metres, radians.
  Pose stop();

 private:
  /// The next line that the process prints, or "" at the end.
  std::string line() const;

  pid_t pid_ = -1;
  int output_ = -1;
  std::string hal_;
};

}  // namespace eyebridge::testing
