#pragma once

#include "strands.hpp"
#include "threads/turn_calls.h"

namespace eyebridge::robios {

/// What the launcher's functions in the C library's place do; `strands` (lent for ever) null in
/// real time. Once a process.
eyebridge_robot_calls robot_calls(Strands* strands);

}  // namespace eyebridge::robios
