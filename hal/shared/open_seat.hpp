#pragma once

#include <memory>

#include "eyebridge/hal/registry.hpp"
#include "eyebridge/hal/shared_world.hpp"

namespace eyebridge::hal {

/// The robot at `seat`, with what the computer adds to it. It keeps its last command when its
/// program has ended. Throws ConfigError as with_host_devices().
std::unique_ptr<Backend> open_seat(const Seat& seat, const BackendContext& context);

}  // namespace eyebridge::hal
