#pragma once

#include <string>
#include <vector>

#include "eyebridge/base/pose.hpp"
#include "running_program.hpp"

namespace eyebridge::testing {

inline const std::string kCommand = EYEBRIDGE_BIN "/eyebridge";

/// The words `eyebridge firmware` and `arguments`.
std::vector<std::string> firmware_command(std::vector<std::string> arguments);

/// What `eyebridge firmware … --hdt` prints. Throws std::runtime_error with what it said instead.
std::string firmware_hdt(std::vector<std::string> arguments);

/// `eyebridge firmware …`, running in `folder`; "" is this process's.
class RunningFirmware : public RunningProgram {
 public:
  explicit RunningFirmware(std::vector<std::string> arguments, const std::string& folder = "");

  /// Waits until the boards listen. What `--hal` must be to reach the first one, by its own word.
  /// Throws std::runtime_error with what was said instead.
  std::string hal();
  /// Ends it as Ctrl-C does. Where the first robot really is then, m and radians. Throws
  /// std::runtime_error with what was said instead.
  Pose stop();
};

}  // namespace eyebridge::testing
