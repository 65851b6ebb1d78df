#pragma once

#include <memory>

#include "eyebridge/hal/registry.hpp"
#include "eyebridge/hal/shared_world.hpp"

namespace eyebridge::hal {

/// The robot at `slot`, with what the computer adds to it. It keeps its last command when its
/// program has ended. Throws ConfigError as with_host_devices().
std::unique_ptr<Backend> open_slot(const WorldSlot& slot, const BackendContext& context);

}  // namespace eyebridge::hal
