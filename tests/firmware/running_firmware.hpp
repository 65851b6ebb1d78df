#pragma once

#include <string>
#include <utility>
#include <vector>

#include "running_program.hpp"

namespace eyebridge::firmware {

inline constexpr int kPatience_ms = 60'000;
inline const std::string kCommand = EYEBRIDGE_BIN "/eyebridge";

/// `eyebridge firmware …`, running in `folder`.
class RunningFirmware : public eyebridge::testing::RunningProgram {
 public:
  RunningFirmware(std::vector<std::string> arguments, const std::string& folder)
      : RunningProgram({with_command(std::move(arguments)), {}, folder}) {}

 private:
  static std::vector<std::string> with_command(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {kCommand, "firmware"});
    return arguments;
  }
};

}  // namespace eyebridge::firmware
