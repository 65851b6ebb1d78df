#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace eyebridge::robios {

/// What a robot runs.
struct RobotProgram {
  std::filesystem::path file;
  std::vector<std::string> arguments;  ///< Without the program's name.
};

}  // namespace eyebridge::robios
