#pragma once

#include <string>
#include <vector>

namespace eyebridge::apps {

/// One thing that a machine has or lacks.
struct Finding {
  std::string what;
  bool needed = false;  ///< By every robot program; else only for some uses.
  bool found = false;
  std::string detail;                    ///< What was found, or what cannot be done without.
  std::string remedy;                    ///< How to get it; empty when nothing can be installed.
  std::vector<std::string> advice = {};  ///< What to do although it was found, a line each.
};

}  // namespace eyebridge::apps
