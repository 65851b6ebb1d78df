#pragma once

#include "launcher_calls.h"

namespace eyebridge::robios {

/// What the launcher's functions in the C library's place do. Once a process.
eyebridge_robot_calls robot_calls();

}  // namespace eyebridge::robios
