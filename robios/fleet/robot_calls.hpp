#pragma once

#include "launcher.h"
#include "strands.hpp"

namespace eyebridge::robios {

/// What the launcher's functions in the C library's place do; `strands` (lent for ever) null in
/// real time. Once a process.
eyebridge_robot_calls robot_calls(Strands* strands);

}  // namespace eyebridge::robios
