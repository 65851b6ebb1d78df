#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace eyebridge::robios {

/// Exit code of a program that cannot be started, as shells say it.
inline constexpr int kCannotRun = 126;

/// Bytes of a program's file.
inline constexpr std::uintmax_t kLargestProgram = std::uintmax_t{4} << 30U;

/// What a robot runs.
struct RobotProgram {
  std::filesystem::path file;
  std::vector<std::string> arguments;  ///< Without the program's name.
};

}  // namespace eyebridge::robios
